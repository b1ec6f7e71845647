// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "numerics/possible.h"

/// Dwells, rises and returns found in a measured lift (docs/theory.md, "Segments of a measured
/// lift").
namespace camlaw::problems {

enum class SegmentKind { Dwell, Rise, Return };
std::string to_string(SegmentKind kind);

/// One stretch of the cycle, angles and lifts in the samples' units.
struct FoundSegment {
  SegmentKind kind;
  /// begin < end; in a periodic lift the last segment may end beyond the period.
  double begin, end;
  double from, to;  ///< lift at the ends
  /// Standard errors of the angles, by the noise and by how many ways of leaving a dwell explain
  /// the samples. 0 where the samples begin and end.
  double begin_error, end_error;
};

struct SegmentOptions {
  /// The whole turn in the unit of the angles, such as 360; none: a part of a cycle.
  std::optional<double> period = {};
  /// Standard deviation of the lift's noise; none: estimated from the samples.
  std::optional<double> noise = {};
  /// What rounding makes of the lifts, a standard deviation: noise is not below it.
  double least_noise = 0;
  /// The shortest dwell, as a share of the period or of the range; a shorter one between a rise and
  /// a return counts as the place where the follower turns.
  double least_dwell = 0.02;
  /// The least lift that counts as a motion, as a share of the whole; never less than 5 deviations
  /// of the noise.
  double least_motion = 0.02;
};

struct FoundSegments {
  std::vector<FoundSegment> segments;  ///< in order, each begins where the last one ends
  double noise;                        ///< standard deviation that was given or estimated
  /// Samples, by their place in what was given, that lie farther from a robust curve than chance
  /// explains; the segments are found without them.
  std::vector<std::size_t> outlying = {};
};

/// Segments of the lift s at angles phi, in any order and spacing, with gaps. Periodic: begins with
/// the first segment that begins in the period which starts at 0. Impossible: lengths that differ,
/// values that are not numbers, fewer than 24 samples, a lift that does not move beyond its noise.
/// Throws std::invalid_argument for options out of range.
Possible<FoundSegments> possible_segments(std::span<const double> phi, std::span<const double> s,
                                          const SegmentOptions& options = {});
/// The same; throws std::invalid_argument where it is impossible.
FoundSegments motion_segments(std::span<const double> phi, std::span<const double> s,
                              const SegmentOptions& options = {});

}  // namespace camlaw::problems
