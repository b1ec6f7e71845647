// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace camlaw::problems {

/// Samples that a fit looks at, x increasing.
struct CornerSamples {
  std::vector<double> x, s;
};

/// Where a motion begins, ends or turns, from the samples around (docs/theory.md, (I10)).
struct Corner {
  double place = 0, level = 0;
  double place_error = 0;  ///< by the noise, and by which shapes explain the samples as well
};

/// What stands on each side of a corner: a dwell, or a motion of that length (above 0).
struct CornerSides {
  double before = 0, after = 0;
};

/// The place between `low` and `high` from which the samples leave the level, to the right, to the
/// left or both, by a power of the distance and higher ones. All samples of a dwell's side count;
/// of a motion's those in a window, which shrinks from half the motion until noise of the deviation
/// `noise`, above 0, explains what is left. With too few samples the answer is `guess` with an
/// error of half the range.
Corner find_corner(const CornerSamples& samples, const CornerSides& sides, double guess, double low,
                   double high, double noise);

}  // namespace camlaw::problems
