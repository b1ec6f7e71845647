// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/model/responses.h"

namespace camlaw::problems {

/// A curve over the turn of a cam: formula(cam, f) or formula(cam, f, x), of an M, the motion of
/// its follower, M::over_angle(), and, if the formula wants it, the place in the cycle.
template <class M, class F>
MechanismResponse cam_curve(ResponseAbout about, F formula) {
  if constexpr (std::is_invocable_v<F, const M&, const FollowerMotion&, const Expression&>) {
    return curve_response<M>(
        std::move(about), turn_of_the_cam(),
        [formula](const M& cam, const Motion<Expression>& motion, const Expression& x) {
          return formula(cam, cam.over_angle(motion), x);
        });
  } else {
    return curve_response<M>(std::move(about), turn_of_the_cam(),
                             [formula](const M& cam, const Motion<Expression>& motion) {
                               return formula(cam, cam.over_angle(motion));
                             });
  }
}

}  // namespace camlaw::problems
