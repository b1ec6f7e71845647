// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optim/problem/problem.h"

/// Checks of what a model says of itself: derivatives against differences, shapes against samples.
namespace camlaw::optim {

/// One derivative beside its difference.
struct DerivativeEntry {
  std::string response;
  std::optional<double> angle;   ///< of a curve
  std::string variable, second;  ///< second is empty for a first derivative
  double exact = 0, difference = 0;
  /// |exact - difference| over the largest derivative there, by scales, or 1e-6 of the value.
  double error = 0;
};

struct DerivativeCheck {
  std::size_t entries = 0;
  DerivativeEntry worst;
  bool agrees = true;               ///< the worst error is at most kDerivativeTolerance
  std::vector<std::string> shapes;  ///< responses whose declared shape does not hold, in words
};

/// Differences of a smooth response leave less; a term that is missing or has the wrong sign shows
/// in the first digits.
inline constexpr double kDerivativeTolerance = 1e-6;

/// Every first and second derivative of objective and constraints at x (of curves at places over
/// the cycle) against central differences extrapolated to step zero (Ridders); differences of the
/// gradient for second derivatives. Shapes are tried on pairs of designs in the box. x should lie
/// inside the bounds: it is moved in by the steps where it does not.
DerivativeCheck check_derivatives(const Problem& problem, Design x);

}  // namespace camlaw::optim
