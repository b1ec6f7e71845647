// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/tolerance/profile_geometry.h"
#include "problems/tolerance/profile_loss.h"

namespace camlaw::problems {

/// Of the follower's acceleration as drawn, away from the cam and towards it.
struct AccelerationPeaks {
  CyclePeak away, towards;
};

/// Of a profile that is made of chords, within a deviation or of a step of the cam angle: how the
/// velocity changes at its corners, and where a roller smooths that, its acceleration and force
/// (docs/theory.md, PE9 and PE10). `drawn`: its peaks without chords.
std::vector<ProfileEffect> chord_effects(const ProfileGeometry& geometry,
                                         const AccelerationPeaks& drawn,
                                         const ProfileErrors& errors);

}  // namespace camlaw::problems
