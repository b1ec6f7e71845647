// SPDX-License-Identifier: MIT
#pragma once

/// The number that a person would have written.
namespace camlaw::problems {

struct SimpleNumber {
  double value = 0;
  int digits = 0;  ///< that it takes to write: significant digits; two for a fraction such as 1/6
};

/// The number with the fewest digits from low to high, the nearest to the middle of those; a
/// fraction of denominator up to 12 where that is shorter. The middle where the bounds are as near
/// as doubles are.
SimpleNumber simplest_between(double low, double high);

}  // namespace camlaw::problems
