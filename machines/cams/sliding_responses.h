// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/listed_responses.h"

/// What a follower that slides on its cam wears, for a machine with sliding_speed() and wear().
namespace camlaw::problems {

enum class SlidingCurve { Speed, Wear };

/// A wear counts where these responses are 0 or above: the force that presses, and of a face the
/// radius that it touches.
template <template <class> class M>
std::vector<MechanismResponse> sliding_responses(const std::vector<std::string>& not_negative) {
  const auto curve = [](SlidingCurve which, ResponseAbout about) {
    return listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                           [](const auto& cam, SlidingCurve wanted, const auto& motion) {
                             const auto f = cam.over_angle(motion);
                             constexpr double kTurns = 1e6;
                             if (wanted == SlidingCurve::Speed) return cam.sliding_speed(f);
                             return kTurns * cam.wear(f);
                           });
  };
  std::vector<MechanismResponse> all{
      curve(SlidingCurve::Speed,
            {"sliding_speed", "m/s", "m/s", "sliding speed of the follower on the cam"}),
      curve(SlidingCurve::Wear,
            {"profile_wear", "mm", "m",
             "depth of wear of the profile in a million turns, by Archard's law"})};
  for (const std::string& name : not_negative) {
    set_defined_while(all, {"profile_wear"}, {.response = name, .lower = 0});
  }
  return all;
}

}  // namespace camlaw::problems
