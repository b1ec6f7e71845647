// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"

/// What a follower that slides on its cam wears, for a machine with sliding_speed() and wear().
namespace camlaw::problems {

/// A wear counts where these responses are 0 or above: the force that presses, and of a face the
/// radius that it touches.
template <class M>
std::vector<MechanismResponse> sliding_responses(const std::vector<std::string>& not_negative) {
  std::vector<MechanismResponse> all{
      cam_curve<M>({"sliding_speed", "m/s", "m/s", "sliding speed of the follower on the cam"},
                   [](const auto& cam, const auto& f) { return cam.sliding_speed(f); }),
      cam_curve<M>({"profile_wear", "mm", "m",
                    "depth of wear of the profile in a million turns, by Archard's law"},
                   [](const auto& cam, const auto& f) {
                     // The response states the wear of so many turns.
                     constexpr int kTurns = 1'000'000;
                     return kTurns * cam.wear(f);
                   })};
  for (const std::string& name : not_negative) {
    set_defined_while(all, {"profile_wear"}, {.response = name, .lower = 0});
  }
  return all;
}

}  // namespace camlaw::problems
