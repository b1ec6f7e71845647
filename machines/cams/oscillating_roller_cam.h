// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_parameters.h"
#include "machines/cams/roller_arm.h"
#include "machines/cams/roller_contact.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A disc cam with an oscillating roller follower (docs/theory.md, "Roller on an arm"). The arm of
/// length l turns about a pivot at the distance d from the cam's centre; psi is its angle to the
/// line of centres, psi_0 at the lowest place, psi_0 + Psi s at displacement s. Fields in SI units.
/// A trailing arm: the cam turns so that the roller's centre moves as the arm does in the rise;
/// LeadingRollerCam turns the other way.
///
/// Valid while arm, distance and prime radius make a triangle.
struct OscillatingRollerCam {
  Given given = {};
  Expression swing = given(cams::kSwing);                        ///< Psi, rad
  Expression base_radius = given(cams::kBaseRadius);             ///< r_b, m
  Expression roller_radius = given(cams::kRollerRadius);         ///< r_r, m
  Expression arm_length = given(cams::kArmLength);               ///< l, m
  Expression pivot_distance = given(cams::kPivotDistance);       ///< d, m
  Expression angular_speed = given(cams::kSpeed);                ///< omega, rad/s
  Expression inertia = given(cams::kInertia);                    ///< J, kg m^2, of all that swings
  Expression spring_rate = given(cams::kArmSpringRate);          ///< c, N m/rad
  Expression spring_preload = given(cams::kArmSpringPreload);    ///< M_0, N m
  Expression load = given(cams::kArmLoad);                       ///< M_L, N m
  Expression face_width = given(cams::kFaceWidth);               ///< b, m
  Expression youngs_modulus = given(cams::kYoungsModulus);       ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);         ///< nu
  Expression cutter_radius = given(cams::kCutterRadius);         ///< r_c, m
  Expression density = given(cams::kDensity);                    ///< rho, kg/m^3, of the cam
  Expression bore_radius = given(cams::kBoreRadius);             ///< r_0, m
  Expression train_stiffness = given(cams::kArmTrainStiffness);  ///< c_t, N m/rad
  Expression train_damping = given(cams::kTrainDamping);         ///< zeta
  Expression end_share = given(cams::kArmEndShare);              ///< kappa, of what moves
  RollerDuty duty = RollerDuty::given_by(given);

  Expression prime_radius() const { return base_radius + roller_radius; }
  /// (M13) cos psi_0 = (l^2 + d^2 - r_p^2) / (2 l d).
  Expression cos_lowest() const {
    const Expression rp = prime_radius();
    return (arm_length * arm_length + pivot_distance * pivot_distance - rp * rp) /
           (2 * arm_length * pivot_distance);
  }
  auto conditions() const {
    return std::to_array<Condition>(
        {{prime_radius(), "base_radius + roller_radius must be above 0"},
         {arm_length + pivot_distance - prime_radius(),
          "base_radius + roller_radius must be below arm_length + pivot_distance"},
         {prime_radius() - absolute(arm_length - pivot_distance),
          "base_radius + roller_radius must be above the difference of arm_length and "
          "pivot_distance"}});
  }
  Expression lowest_angle() const { return pi() / 2 - asin(cos_lowest()); }
  /// What swings counts as what slides: J for m, torques for forces.
  FollowerLoad follower() const {
    return {inertia, spring_rate, spring_preload, load, angular_speed};
  }
  RollerContact roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }
  CamBlank blank() const { return {density, bore_radius, face_width}; }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(swing, motion);
  }
  CamCurve pitch_curve(const FollowerMotion& f) const { return arm().pitch_curve(angle(f), f); }
  /// (M14) Pressure angle, rad.
  Expression pressure_angle(const FollowerMotion& f) const {
    return arm().pressure_angle(angle(f), f);
  }
  /// (M15) Force between roller and cam, N: N = M / (l cos alpha).
  Expression contact_force(const FollowerMotion& f) const {
    return follower().force(f) / (arm_length * cos(pressure_angle(f)));
  }
  /// What the cam turns under the arm by its own turn, 1 + psi' (RB1): they turn against one
  /// another in the rise.
  Expression turning(const FollowerMotion& f) const { return f.ds + 1; }

 private:
  RollerArm arm() const { return {arm_length, pivot_distance}; }
  Expression angle(const FollowerMotion& f) const { return f.s + lowest_angle(); }
};

}  // namespace camlaw
