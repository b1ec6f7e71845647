// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/cams/follower_responses.h"
#include "machines/model/mechanism.h"

/// Whether a cam can be made and run: the checks of each kind of follower, and what they need
/// (docs/problem-files.md, "[buildable]").
namespace camlaw::problems {

using Checks = std::vector<BuildableCheck>;

/// A profile that a roller leaves without a look at its tools.
Checks undercut_checks();
/// A profile that a roller leaves: undercut on either flank, hollows against their tools.
Checks roller_checks();
/// Hollows of a profile that undercut does not concern.
Checks hollow_checks();
/// Of a flat face: a profile without a cusp, which has no hollows.
Checks face_checks();
/// Both cams of a conjugate pair, which closes by its form.
Checks conjugate_checks();
/// A pair that a spring or a load closes: contact at the stated speed, and its spring.
Checks force_closure_checks(const FollowerWords& words);
Checks wall_checks();
/// The pivot of an arm outside the circle that the cam turns in.
Checks pivot_checks();
/// The arm of a roller beside the cam.
Checks arm_checks();
/// The shaft of a turret outside the circles that its cams turn in.
Checks shaft_checks();
/// Both flanks along a roller that runs between ribs, the wall below its end, and the stress there.
Checks rib_checks();
/// Neighbouring rollers of a turret.
Checks ring_checks();
/// The stress where the cam is touched.
Checks stress_checks();
/// The same where there may be a groove: there on the flank that bears.
Checks roller_stress_checks();

/// Friction in the guide of a translating follower, where it is stated.
Checks guide_checks();

/// A mechanism with all of these, those of its elastic follower, and the inputs that they have.
Mechanism checked(Mechanism mechanism, const std::vector<Checks>& checks);

}  // namespace camlaw::problems
