// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/faulty_rows.h"
#include "fitting/motions/law_fit.h"
#include "fitting/motions/segments.h"
#include "numerics/tables/sample_table.h"

/// From a measured table to motions: which column is what, in which unit, and where the follower
/// moves.
namespace camlaw::problems {

/// The columns of a table as a place and a displacement, velocity or acceleration. The place is the
/// column called angle, phi, x, t, ... (numerics/tables/column_names.h), else the first; the value
/// that named as a displacement, velocity or acceleration, else the second. Angles become deg,
/// lengths mm, times s, what has no unit stays, but for angles of which the values tell that they
/// are degrees; velocity is in mm/deg and the like. Rows whose place lies far from all others are
/// left out. Many samples are condensed(). Throws std::invalid_argument naming the column and the
/// units that it may have.
MotionRecord motion_record(const SampleTable& table);
/// Whether a column is named as a displacement: lift, s, ...
bool has_lift(const SampleTable& table);
/// Of that the samples alone.
MotionSamples motion_samples(const SampleTable& table);

/// Begin, end, stroke and zero of a motion, and one more to tell an error by.
inline constexpr std::size_t kFewestOfMotion = 5;

/// One rise or return of a cycle, and its samples.
struct FoundMotion {
  MotionGuess guess;
  MotionSamples samples;  ///< those of the motion and half of the dwells beside it
  /// Whether the record begins, or ends, with it: no rest beyond is known of.
  bool begins_record = false, ends_record = false;
};

struct FoundCycle {
  std::vector<FoundSegment>
      segments;  ///< dwells and motions in order; empty where they were not looked for
  std::vector<FoundMotion> motions;
  double noise = 0;          ///< of the lift, where segments were looked for
  std::size_t outlying = 0;  ///< samples that the search left out; they belong to motions still
};

/// The turn in deg where angles of a lift cover nearly all of it; else 0.
double cycle_period(const MotionSamples& samples);

/// Motions that samples show. Displacements of 24 samples and more are searched for dwells, rises
/// and returns, over the turn where their angles cover nearly all of it; of others all samples are
/// one motion. Impossible where nothing moves and where angles go beyond a turn.
Possible<FoundCycle> possible_motions(const MotionSamples& samples);
/// The same; throws std::invalid_argument where it is impossible.
FoundCycle find_motions(const MotionSamples& samples);

}  // namespace camlaw::problems
