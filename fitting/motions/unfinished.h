// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fitting/motions/motion_data.h"

/// Motions of which a record does not show where they begin or end.
namespace camlaw::problems {

/// At which ends of a record its motion is still under way, so that nothing but a law tells where
/// it comes to rest, and at what stroke.
struct OpenEnds {
  bool begin = false, end = false;

  bool any() const { return begin || end; }
};

/// (FS11): where the record begins or ends with the motion and shows less than three samples at
/// rest, that end is unfinished if the motion moves there by 0.45 or more of the greatest velocity
/// that the samples show, or if it lies beyond the record at the edge of where it was looked for,
/// by a law of the ranking with a hundredth of the probability or more.
OpenEnds unfinished_ends(const FoundMotion& motion, const std::vector<LawFit>& ranking);

/// Why such a motion is not trusted; empty where it is finished.
std::string unfinished_words(const OpenEnds& ends, const MotionSamples& samples);

/// Why a law is not trusted of which a number stands at the edge of what was tried: the begin or
/// end where it was looked for, a coefficient where its range ends. Where that is 0 or 1 it is the
/// family's own end: a phase of no length, or all of it. Empty where none does.
std::string edge_words(const LawFit& law);

}  // namespace camlaw::problems
