// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "optim/solvers/solver.h"

/// What both back ends ask and answer in the same way.
namespace camlaw::optim {

/// How a run ended, in our words.
struct RunEnd {
  Status status;
  std::string message;
};

inline bool all_finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace camlaw::optim
