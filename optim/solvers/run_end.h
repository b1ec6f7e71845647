// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <string>

#include "optim/solvers/solver.h"

/// What back ends ask and answer in the same way.
namespace camlaw::optim {

/// How a run ended, in our words.
struct RunEnd {
  Status status;
  std::string message;
};

inline bool is_stopped(const SolverOptions& options) {
  return options.stop != nullptr && options.stop->load();
}

/// Whether a run that began then has used up its time.
inline bool is_late(const SolverOptions& options, std::chrono::steady_clock::time_point began) {
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
  return options.time_limit && spent.count() > *options.time_limit;
}

inline bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Whether a variable without a bound has gone far: inside a box nothing falls without end.
inline bool is_far_out(const Program& program, std::span<const double> y) {
  // In typical changes: a claim that nothing bounds the objective is not believed from nearer.
  constexpr double kFar = 1e4;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const bool open = std::isinf(program.lower()[i]) || std::isinf(program.upper()[i]);
    if (open && std::abs(y[i]) > kFar) return true;
  }
  return false;
}

}  // namespace camlaw::optim
