// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/guided_follower.h"
#include "machines/cams/roller_contact.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A disc cam with a translating roller follower, offset or in line (docs/theory.md, "Roller on a
/// disc cam"). Fields in SI units. The follower moves along y at x = offset; the cam turns so that
/// a positive offset lowers the pressure angle of the rise. The other rotation is the other sign of
/// the offset.
///
/// Valid while |offset| is less than the prime radius, base_radius + roller_radius; with friction
/// in the guide, while the roller stays outside it, stroke at most overhang.
struct RollerCam {
  Given given = {};
  Expression stroke = given(cams::kStroke);           ///< h, m
  Expression base_radius = given(cams::kBaseRadius);  ///< r_b, m, least radius of the cam's profile
  Expression roller_radius = given(cams::kRollerRadius);    ///< r_r, m
  Expression offset = given(cams::kOffset);                 ///< e, m
  Expression angular_speed = given(cams::kSpeed);           ///< omega, rad/s
  Expression mass = given(cams::kMass);                     ///< m, kg
  Expression spring_rate = given(cams::kSpringRate);        ///< c, N/m
  Expression spring_preload = given(cams::kSpringPreload);  ///< F_0, N
  Expression load = given(cams::kLoad);                     ///< F_L, N
  Expression face_width = given(cams::kFaceWidth);          ///< b, m, of the contact
  Expression youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa, of cam and roller
  Expression poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  Expression cutter_radius =
      given(cams::kCutterRadius);                     ///< r_c, m, of the tool that cuts the profile
  Expression density = given(cams::kDensity);         ///< rho, kg/m^3, of the cam
  Expression bore_radius = given(cams::kBoreRadius);  ///< r_0, m
  Expression guide_friction = given(cams::kGuideFriction);  ///< mu, between follower and guide
  Expression guide_length = given(cams::kGuideLength);      ///< l_g, m
  Expression overhang = given(cams::kOverhang);  ///< a, m, of the roller from its guide at s = 0
  Expression train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  Expression train_damping = given(cams::kTrainDamping);      ///< zeta
  Expression end_share = given(cams::kEndShare);              ///< kappa, of what moves
  RollerDuty duty = RollerDuty::given_by(given);

  auto conditions() const {
    return std::to_array<Condition>(
        {{prime_radius(), "base_radius + roller_radius must be above 0"},
         {prime_radius() - absolute(offset),
          "offset must be less in size than base_radius + roller_radius"}});
  }
  Expression prime_radius() const { return base_radius + roller_radius; }
  /// (M5) Height of the roller's centre at s = 0: y_0 = sqrt(r_p^2 - e^2).
  Expression lowest_height() const {
    return sqrt(prime_radius() * prime_radius() - offset * offset);
  }
  FollowerLoad follower() const { return {mass, spring_rate, spring_preload, load, angular_speed}; }
  RollerContact roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }
  CamBlank blank() const { return {density, bore_radius, face_width}; }
  SlidingGuide guide() const { return {guide_friction, guide_length}; }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// The roller's centre, on the pitch curve: w = e + i y, w1 = y + i (s' - e), w2 = 2 s' - e +
  /// i (s'' - y) with y = y_0 + s.
  CamCurve pitch_curve(const FollowerMotion& f) const {
    const Expression y = f.s + lowest_height();
    return {offset, y, y, f.ds - offset, 2 * f.ds - offset, f.dds - y};
  }
  /// (M6) Pressure angle, rad: tan alpha = (s' - e) / (y_0 + s). NaN where the roller's centre is
  /// not above the cam's, y_0 + s <= 0: there is no such cam.
  Expression pressure_angle(const FollowerMotion& f) const {
    const Expression y = f.s + lowest_height();
    return atan((f.ds - offset) / where_positive(y, y));
  }
  /// (M37) What friction in the guide takes of the force along the way, |tan alpha| mu
  /// (2 a + l_g) / l_g with the overhang a - s, signed as the velocity. At 1 a rising follower
  /// jams.
  GuideShares guide_shares(const FollowerMotion& f) const {
    const Expression slope = (f.ds - offset) / (f.s + lowest_height());
    const Expression size = is_number(offset, 0) ? slope : along(f.ds, slope);
    const Expression share = guide().share_across(guide_overhang(*this, f), size);
    return {share, share};
  }
  /// (M9), (M38) Force between roller and cam, N: N = F / (cos alpha (1 - q)), q the guide's share
  /// where F is above 0 and its negative below. NaN where the follower jams, and where there is no
  /// pressure angle. 1 / cos alpha = sqrt(1 + tan^2 alpha) is bounded exactly where alpha is 0,
  /// whatever the size of the cam is.
  Expression contact_force(const FollowerMotion& f) const {
    const Expression y = f.s + lowest_height();
    const Expression slope = (f.ds - offset) / where_positive(y, y);
    return guided_force(*this, f) * sqrt(slope * slope + 1);
  }
  /// (M39) Torque on the cam's shaft with the guide's friction, N m: N cos alpha s'.
  Expression drive_torque(const FollowerMotion& f) const { return guided_torque(*this, f); }
  /// What the cam turns under the follower by its own turn: 1, as the follower does not turn (RB1).
  Expression turning(const FollowerMotion&) const { return 1; }
};

}  // namespace camlaw
