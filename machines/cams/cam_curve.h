// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/model/responses.h"

namespace camlaw::problems {

/// A curve over the turn of a cam: formula(cam, f) or formula(cam, f, x), of an M<Expression>, the
/// motion of its follower, M::over_angle(), and, if the formula wants it, the place in the cycle.
template <template <class> class M, class F>
MechanismResponse cam_curve(ResponseAbout about, F formula) {
  using Cam = M<Expression>;
  using X = Expression;
  if constexpr (std::is_invocable_v<F, const Cam&, const FollowerMotion<X>&, const X&>) {
    return curve_response<M>(std::move(about), turn_of_the_cam(),
                             [formula](const Cam& cam, const Motion<X>& motion, const X& x) {
                               return formula(cam, cam.over_angle(motion), x);
                             });
  } else {
    return curve_response<M>(std::move(about), turn_of_the_cam(),
                             [formula](const Cam& cam, const Motion<X>& motion) {
                               return formula(cam, cam.over_angle(motion));
                             });
  }
}

}  // namespace camlaw::problems
