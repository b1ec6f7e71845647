// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "kinematics/law.h"

/// Which spans between the knots of a free law are halved next, and into what (docs/theory.md,
/// "Adding knots where they help most").
namespace camlaw::problems {

/// Neighbouring spans that were halved together, for the `times`-th time in a row.
struct Halved {
  double from, to;
  double promise;  ///< the largest of them
  int times = 1;
};

/// Knots inside (0, 1), and what the last round halved to come to them.
struct DividedKnots {
  std::vector<double> knots;
  std::vector<Halved> last = {};

  /// How often the spans were halved at once, where that was most often; 1 of the first knots.
  int halvings() const;
};

/// (KN1) How much each span between two knots could gain: the jumps of the highest derivative at
/// its ends, by what they do to the acceleration within it, over that acceleration and the mean
/// one.
std::vector<double> promises(const Law<double>& law, const std::vector<double>& knots);

/// Knots with more in each span that promises much, and in its mirror image where the law is
/// symmetric. No span is halved more than `most` times at once.
DividedKnots with_more(const DividedKnots& divided, std::vector<double> promise, bool symmetric,
                       int most);

}  // namespace camlaw::problems
