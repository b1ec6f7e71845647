// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numerics/formula/formula.h"
#include "numerics/formula/hand_back.h"

namespace camlaw {

/// A formula's value with its slopes by every input, from one pass through its steps and one back
/// (docs/theory.md, (RF1) and (RF2)), so that they cost the same for any number of inputs.
class FormulaSlopes {
 public:
  /// Of a formula that has no roots.
  explicit FormulaSlopes(const Formula& formula);
  /// Whether a formula's slopes are found so: none of its steps is a root.
  static bool knows(const Formula& formula);

  /// The value at u, which has a number for each input, but for last ones that the formula does not
  /// use, and slopes[i], the derivative by u[i]; in double, or in Dual, whose derivatives are those
  /// of the value and of the slopes. A slope that has no bound, as that of a square root at 0,
  /// comes out infinite or not a number.
  template <class T>
  T operator()(std::span<const T> u, std::span<T> slopes) const;

  /// The value at u, its gradient g and its second derivatives, h[i (i + 1) / 2 + k] by u[i] and
  /// u[k], k <= i: a pass each way for every kDualWidth of the inputs that the value depends on.
  double hessian(std::span<const double> u, std::span<double> g, std::span<double> h) const;

 private:
  template <class T>
  void go_through(std::span<const T> u, T* results) const;

  std::vector<std::size_t> uses_;
  std::vector<BackStep> varying_;
  std::vector<double> constants_;  ///< results of the steps that no input reaches
};

}  // namespace camlaw
