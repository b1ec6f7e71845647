// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fitting/motions/corner.h"
#include "fitting/motions/segments.h"
#include "fitting/samples/lift_samples.h"

/// Where the motions of a lift begin, turn and end, as far as a smooth curve shows it.
namespace camlaw::problems {

/// A measured lift as the search for its segments sees it.
struct LiftCurve {
  CornerSamples samples;
  optim::SmoothingSpline curve;  ///< through the samples
  bool is_periodic;
  double begin, end;   ///< of the period, or of the samples
  double least;        ///< the least lift that counts as a motion
  double least_dwell;  ///< the shortest dwell, an angle
  double noise;        ///< above 0: samples without noise have digits still

  double length() const { return end - begin; }
};

Possible<LiftCurve> lift_curve(const LiftSamples& lift, const SegmentOptions& options);

/// The samples from `low` to `high`, periodic ones as often as they come.
CornerSamples samples_between(const LiftCurve& lift, double low, double high);

/// Where a motion begins, ends or turns, before and after it is looked at closely.
struct MotionNode {
  double place, level;
  double error = 0;
};

/// Motions between nodes that follow one another without a dwell.
using MotionChain = std::vector<MotionNode>;

/// The motions from the end of each dwell to the next; none where nothing moves. A chain that
/// begins in the period may end beyond it.
std::vector<MotionChain> rough_chains(const LiftCurve& lift);

}  // namespace camlaw::problems
