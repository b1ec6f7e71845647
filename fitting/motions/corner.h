// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace camlaw::problems {

/// Samples that a fit looks at, x increasing, with a smooth curve through them.
struct CornerSamples {
  std::vector<double> x, s;
  std::vector<double> curve, leverage;  ///< the curve there, and how much it follows the sample
};

/// Where a motion begins, ends or turns, from the samples around (docs/theory.md, (I10)).
struct Corner {
  double place = 0, level = 0;
  double place_error = 0;  ///< standard, by the noise and by how many ways explain the samples
};

/// What stands on each side of a corner: a dwell, or a motion of that length (above 0).
struct CornerSides {
  double before = 0, after = 0;
};

/// The place between `low` and `high` from which the samples leave the level, to the right, to the
/// left or both, by a power of the distance and higher ones. All samples of a dwell's side count;
/// of a motion's those in windows from half the motion to a sixteenth, beyond them the smooth curve
/// stands for the motion. The mean over powers and windows, each as likely as noise of the
/// deviation `noise`, above 0, leaves it. With too few samples the answer is `guess` with an error
/// of half the range.
Corner find_corner(const CornerSamples& samples, const CornerSides& sides, double guess, double low,
                   double high, double noise);

}  // namespace camlaw::problems
