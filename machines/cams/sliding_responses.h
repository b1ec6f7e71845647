// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/listed_responses.h"

/// What a follower that slides on its cam wears, for a machine with sliding_speed() and wear().
namespace camlaw::problems {

enum class SlidingCurve { Speed, Wear };

template <template <class> class M>
std::vector<MechanismResponse> sliding_responses() {
  const auto curve = [](SlidingCurve which, ResponseAbout about) {
    return listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                           [](const auto& cam, SlidingCurve wanted, const auto& motion) {
                             const auto f = cam.over_angle(motion);
                             constexpr double kTurns = 1e6;
                             if (wanted == SlidingCurve::Speed) return cam.sliding_speed(f);
                             return kTurns * cam.wear(f);
                           });
  };
  return {curve(SlidingCurve::Speed,
                {"sliding_speed", "m/s", "m/s", "how fast the follower slides on the cam"}),
          curve(SlidingCurve::Wear,
                {"profile_wear", "mm", "m",
                 "what the profile loses at the contact in a million turns, by Archard's law"})};
}

}  // namespace camlaw::problems
