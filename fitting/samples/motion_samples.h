// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace camlaw::problems {

/// Samples of a motion between two rests: places in any order, spacing and number, values of the
/// displacement or of one of its derivatives by the place.
struct MotionSamples {
  std::vector<double> place, value;
  int order = 0;  ///< 0 displacement, 1 velocity, 2 acceleration
  std::string place_unit = "1", unit = "1";
  std::string length_unit = "1";  ///< of the displacement, whatever the order
  double resolution = 0;          ///< what values are rounded to; 0: to no more than doubles are
  std::size_t each = 1;           ///< measured samples that one of these is the mean of
  std::size_t left_out = 0;       ///< of those, far off their neighbours
  std::size_t lacking = 0;        ///< rows of the table without a number

  /// None of these samples: what they would be like.
  MotionSamples none() const {
    return {{}, {}, order, place_unit, unit, length_unit, resolution, each};
  }
};

/// Standard deviation of what rounding makes of values: resolution / sqrt(12).
double rounding_deviation(const MotionSamples& samples);

/// Samples from `low` to `high`, in a cycle that begins anew after `period` (0: not at all).
MotionSamples between(const MotionSamples& all, double low, double high, double period = 0);

/// Where a motion is looked for to begin with.
struct MotionGuess {
  double begin = 0, end = 1;  ///< places
  double from = 0, to = 1;    ///< displacement there
};

/// A motion that the samples show: from the first place to the last where these are all there is.
MotionGuess guess_motion(const MotionSamples& samples);

}  // namespace camlaw::problems
