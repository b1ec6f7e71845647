// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/guided_follower.h"
#include "machines/cams/roller_contact.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// An end (face) or barrel cam with a roller that moves along the cam's axis (docs/theory.md, "End
/// and barrel cams"), developed at the mean radius of the roller's track. Fields in SI units.
///
/// Valid, with friction in the guide, while the roller stays outside it, stroke at most overhang.
struct EndCam {
  Given given = {};
  Expression stroke = given(cams::kStroke);       ///< h, m
  Expression radius = given(cams::kTrackRadius);  ///< R, m, of the middle of the roller's track
  Expression roller_radius = given(cams::kRollerRadius);                  ///< r_r, m
  Expression angular_speed = given(cams::kSpeed);                         ///< omega, rad/s
  Expression mass = given(cams::kMass);                                   ///< m, kg
  Expression spring_rate = given(cams::kSpringRate.by_default(0));        ///< c, N/m
  Expression spring_preload = given(cams::kSpringPreload.by_default(0));  ///< F_0, N
  Expression load = given(cams::kLoad);                                   ///< F_L, N
  Expression face_width = given(cams::kFaceWidth);                        ///< b, m, of the contact
  Expression youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa, of cam and roller
  Expression poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  Expression cutter_radius =
      given(cams::kCutterRadius);  ///< r_c, m, of the tool that cuts the track
  Expression guide_friction = given(cams::kGuideFriction);  ///< mu, between follower and guide
  Expression guide_length = given(cams::kGuideLength);      ///< l_g, m
  Expression overhang = given(cams::kOverhang);  ///< a, m, of the roller from its guide at s = 0
  Expression train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  Expression train_damping = given(cams::kTrainDamping);      ///< zeta
  Expression end_share = given(cams::kEndShare);              ///< kappa, of what moves
  RollerDuty duty = RollerDuty::given_by(given);

  auto conditions() const { return std::to_array<Condition>({{radius, "radius must be above 0"}}); }
  FollowerLoad follower() const { return {mass, spring_rate, spring_preload, load, angular_speed}; }
  RollerContact roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }
  SlidingGuide guide() const { return {guide_friction, guide_length}; }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// (M17) The roller's centre on the developed cam: w = i s, w1 = R + i s', w2 = i s''. Its
  /// curvature (M4) is k = -s'' / R^2 / (1 + (s' / R)^2)^(3/2), positive where the cam is convex.
  CamCurve pitch_curve(const FollowerMotion& f) const {
    const Expression none = 0;
    return {none, f.s, none + radius, f.ds, none, f.dds};
  }
  /// A point of a curve on the cam, developed: x along the circumference.
  std::pair<Expression, Expression> placed(const CamPoint& p, const Expression& phi) const {
    return {p.x + radius * phi, p.y};
  }
  /// (M16) Pressure angle, rad: tan alpha = s' / R.
  Expression pressure_angle(const FollowerMotion& f) const { return atan(f.ds / radius); }
  /// (M37) What friction in the guide takes of the force along the way. tan alpha = s' / R has the
  /// velocity's sign.
  GuideShares guide_shares(const FollowerMotion& f) const {
    const Expression share = guide().share_across(guide_overhang(*this, f), f.ds / radius);
    return {share, share};
  }
  /// (M18), (M38) Force between roller and cam, N, signed as the force along the way:
  /// N = F / (cos alpha (1 - q)). NaN where the follower jams.
  Expression contact_force(const FollowerMotion& f) const {
    const Expression slope = f.ds / radius;
    return guided_force(*this, f) * sqrt(slope * slope + 1);
  }
  /// (M39) Torque on the cam's shaft with the guide's friction, N m: N cos alpha s'.
  Expression drive_torque(const FollowerMotion& f) const { return guided_torque(*this, f); }
  /// About the roller's axis the cam does not turn (RB1).
  Expression turning(const FollowerMotion&) const { return 0; }
};

}  // namespace camlaw
