// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "optim/problem/function.h"

namespace camlaw::optim {

/// Linear functions that rows of one bound were made of, to tell those that say the same: where a
/// curve is level or joins smoothly neighbouring places give one row, and a return that mirrors the
/// rise gives those of the rise again.
class LinearRows {
 public:
  /// Values are compared at one design. Slopes may differ by a share of the steepest.
  LinearRows(Design at, double share) : at_(at.begin(), at.end()), share_(share) {}

  /// Takes sign * function. False where it is known: the slopes are the same, and the values to
  /// `slack`.
  bool add(const Function& function, double sign, double slack);

 private:
  struct Line {
    std::vector<std::size_t> inputs;  ///< those that count, increasing
    std::vector<double> slopes;
  };

  std::vector<double> at_;
  double share_;
  /// By the first input that counts, then by the value.
  std::map<std::size_t, std::multimap<double, Line>> lines_;
};

}  // namespace camlaw::optim
