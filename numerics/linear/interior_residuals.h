// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

/// How large residuals of a program's conditions are, and how far a step may go.
namespace camlaw::optim::interior {

using Eigen::VectorXd;

/// What may be left of the conditions at an optimum.
inline constexpr double kLeft = 1e-9;
/// A residual counts over this part of its terms' sum.
inline constexpr double kTerms = 1e-6;

/// The largest of these residuals, each over a millionth of its terms' sum where that is more
/// than 1: terms of any size cancel to as many digits. No terms: none is.
inline double relative(const VectorXd& left, const VectorXd& terms) {
  double largest = 0;
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    const double size = terms.size() > 0 ? std::max(1.0, kTerms * terms[i]) : 1;
    const double share = std::abs(left[i]) / size;
    if (!(share <= largest)) largest = share;  // also what is not a number
  }
  return largest;
}
inline double largest(const VectorXd& left) {
  if (left.size() == 0) return 0;
  return left.allFinite() ? left.cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
}

/// How much of a step keeps x at 0 or above: 1 at most.
inline double reach(const VectorXd& x, const VectorXd& step) {
  double result = 1;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x[i] + result * step[i] < 0) result = -x[i] / step[i];
  }
  return result;
}
/// A little less, so that no slack or multiplier ends at 0.
inline double short_of(double reach) { return reach < 1 ? 0.995 * reach : 1; }

}  // namespace camlaw::optim::interior
