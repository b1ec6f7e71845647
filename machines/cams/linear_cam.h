// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_parameters.h"
#include "machines/cams/end_cam.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A plate that slides evenly by its travel L in a cycle under a translating roller follower, whose
/// way is square to the plate's (docs/theory.md, "Cam plates"): a developed end cam of the
/// radius L / (2 pi). Fields in SI units. Radians are of the cycle, 2 pi each.
///
/// Valid for one passage of the plate, or one that repeats; what a plate does that stops and comes
/// back is another cycle. With friction in the guide, while the roller stays outside it.
struct LinearCam {
  Given given = {};
  Expression stroke = given(cams::kStroke);  ///< h, m
  Expression travel =
      given({"travel", "L", "mm", "m", "travel of the plate in a cycle", 300, 1e-3, 1e6});
  Expression roller_radius = given(cams::kRollerRadius);  ///< r_r, m
  Expression angular_speed = given(cams::kSpeed.meaning_that(
      "cycles of the plate per minute"));                   ///< omega, rad/s, 2 pi by cycle
  Expression mass = given(cams::kMass);                     ///< m, kg
  Expression spring_rate = given(cams::kSpringRate);        ///< c, N/m
  Expression spring_preload = given(cams::kSpringPreload);  ///< F_0, N
  Expression load = given(cams::kLoad);                     ///< F_L, N
  Expression face_width = given(cams::kFaceWidth);          ///< b, m, of the contact
  Expression youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa, of plate and roller
  Expression poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  Expression cutter_radius =
      given(cams::kCutterRadius);  ///< r_c, m, of the tool that cuts the profile
  Expression guide_friction = given(cams::kGuideFriction);  ///< mu, between follower and guide
  Expression guide_length = given(cams::kGuideLength);      ///< l_g, m
  Expression overhang = given(cams::kOverhang);  ///< a, m, of the roller from its guide at s = 0
  Expression train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  Expression train_damping = given(cams::kTrainDamping);      ///< zeta
  Expression end_share = given(cams::kEndShare);              ///< kappa, of what moves
  RollerDuty duty = RollerDuty::given_by(given);

  auto conditions() const { return std::to_array<Condition>({{travel, "travel must be above 0"}}); }
  /// Way of the plate by radian.
  Expression radius() const { return travel / (2 * pi()); }
  EndCam developed() const {
    return {Given::unset(), stroke,         radius(),       roller_radius,
            angular_speed,  mass,           spring_rate,    spring_preload,
            load,           face_width,     youngs_modulus, poisson_ratio,
            cutter_radius,  guide_friction, guide_length,   overhang};
  }
  FollowerLoad follower() const { return developed().follower(); }
  RollerContact roller() const { return developed().roller(); }
  SlidingGuide guide() const { return developed().guide(); }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return developed().over_angle(motion);
  }
  /// The roller's centre on the plate.
  CamCurve pitch_curve(const FollowerMotion& f) const { return developed().pitch_curve(f); }
  std::pair<Expression, Expression> placed(const CamPoint& p, const Expression& phi) const {
    return developed().placed(p, phi);
  }
  /// (M16) Pressure angle, rad: tan alpha = s' / R.
  Expression pressure_angle(const FollowerMotion& f) const { return developed().pressure_angle(f); }
  /// (M37) What friction in the guide takes of the force along the way.
  GuideShares guide_shares(const FollowerMotion& f) const { return developed().guide_shares(f); }
  /// (M18), (M38) Force between roller and plate, N: N = F / (cos alpha (1 - q)).
  Expression contact_force(const FollowerMotion& f) const { return developed().contact_force(f); }
  /// (M39) What stands for the torque on a shaft, N m: the plate's force by its way per radian.
  Expression drive_torque(const FollowerMotion& f) const { return developed().drive_torque(f); }
  /// (M26) Force that moves the plate, N: P = N sin alpha.
  Expression plate_force(const FollowerMotion& f) const { return drive_torque(f) / radius(); }
  /// The plate does not turn (RB1).
  Expression turning(const FollowerMotion&) const { return 0; }
};

}  // namespace camlaw
