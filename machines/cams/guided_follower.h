// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/sliding_guide.h"

/// What the guide of a translating follower makes of its forces (docs/theory.md, "Friction in the
/// guide"), alike for every cam that has follower(), guide() and guide_shares().
namespace camlaw {

/// What friction takes of a force that pushes the follower along its way, and of one that pulls it,
/// each signed as the velocity.
struct GuideShares {
  Expression pushing, pulling;
};

/// (M37) a - s, m: how far the contact is before the guide. Below 0 it enters the guide. For a cam
/// with the field `overhang`.
template <class Cam>
Expression guide_overhang(const Cam& cam, const FollowerMotion& f) {
  return cam.overhang - f.s;
}

/// (M38) Fraction of the force along the way that friction in the guide takes; at 1 the follower
/// jams.
template <class Cam>
Expression guide_fraction(const Cam& cam, const FollowerMotion& f) {
  const auto guide = cam.guide();
  if (is_number(guide.friction, 0)) return 0;
  const GuideShares shares = cam.guide_shares(f);
  return guide.taken(cam.follower().force(f), shares.pushing, shares.pulling);
}

/// (M38) N cos alpha, N: the force along the way with the guide's friction. NaN where the follower
/// jams.
template <class Cam>
Expression guided_force(const Cam& cam, const FollowerMotion& f) {
  const Expression force = cam.follower().force(f);
  const auto guide = cam.guide();
  if (is_number(guide.friction, 0)) return force;
  return guide.driving_force(force, guide_fraction(cam, f));
}

/// (M39) Torque on the cam's shaft with the guide's friction, N m: N cos alpha s'.
template <class Cam>
Expression guided_torque(const Cam& cam, const FollowerMotion& f) {
  return guided_force(cam, f) * f.ds;
}

}  // namespace camlaw
