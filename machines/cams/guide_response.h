// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"
#include "machines/cams/guided_follower.h"

namespace camlaw::problems {

/// (M38) What friction in its guide takes of a translating follower's force, for a machine with
/// guide_shares().
template <class M>
MechanismResponse guide_response() {
  return cam_curve<M>(
      {"guide_fraction", "1", "1",
       "fraction of the cam's force along the follower's path that friction in the guide takes; at "
       "1 the follower jams"},
      [](const auto& cam, const auto& f) { return guide_fraction(cam, f); });
}

/// (M37) How far the contact of a translating follower is before its guide, for a machine with
/// overhang.
template <class M>
MechanismResponse overhang_response() {
  return cam_curve<M>(
      {"guide_overhang", "mm", "m",
       "distance of the contact from its guide, overhang less displacement; below 0 the contact "
       "would enter the guide"},
      [](const auto& cam, const auto& f) { return guide_overhang(cam, f); });
}

/// With friction in a guide, its contact stays outside it.
inline ValidityLimit outside_guide() {
  return {.response = "guide_overhang", .lower = 0, .only_with = "guide_friction"};
}

}  // namespace camlaw::problems
