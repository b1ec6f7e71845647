// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/peak_model.h"

/// Branch and bound over a law's smooth pieces (docs/theory.md, "Peaks").
namespace camlaw::detail {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// The maximum of sign * quantity over a law's smooth pieces, as the search narrows it.
struct Question {
  Quantity quantity;
  double sign;
  double known = -kUnbounded;    ///< a value that is reached: lower bound of the maximum
  double ceiling = -kUnbounded;  ///< upper bound of the maximum over all closed boxes
  Extremum peak{-kUnbounded, 0, 0, Where::Begin};     ///< best piece end or stationary point
  Extremum sample{-kUnbounded, 0, 0, Where::Sample};  ///< best middle of a box
};

/// Highest and lowest of each quantity: entry 2 i and 2 i + 1.
using Questions = std::array<Question, 2 * kQuantities>;

/// Runs the search. T = double finds the peaks of the law, T = Interval proves them; `plain` is the
/// law of midpoints (the law itself for double). A box is closed when its upper bound is within
/// `tolerance` of what is known, as a part of the quantity's largest size. `places` are points
/// where peaks may be expected: the better they are, the sooner boxes close.
template <class T>
Questions search_peaks(const Law<T>& law, const Law<double>& plain, double tolerance,
                       std::span<const double> places);

}  // namespace camlaw::detail
