// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/listed_responses.h"

namespace camlaw::problems {

/// (M38) What friction in its guide takes of a translating follower's force, for a machine with
/// guide_fraction().
template <template <class> class M>
MechanismResponse guide_response() {
  return curve_response<M>(
      {"guide_fraction", "1", "1",
       "fraction of the cam's force along the follower's path that friction in the guide takes; at "
       "1 the follower jams"},
      turn_of_the_cam(), [](const auto& cam) {
        return [cam](const auto& motion) { return cam.guide_fraction(cam.over_angle(motion)); };
      });
}

}  // namespace camlaw::problems
