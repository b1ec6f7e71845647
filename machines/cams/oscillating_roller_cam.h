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
template <class T>
struct OscillatingRollerCam {
  Given<T> given = {};
  T swing = given(cams::kSwing);                        ///< Psi, rad
  T base_radius = given(cams::kBaseRadius);             ///< r_b, m
  T roller_radius = given(cams::kRollerRadius);         ///< r_r, m
  T arm_length = given(cams::kArmLength);               ///< l, m
  T pivot_distance = given(cams::kPivotDistance);       ///< d, m
  T angular_speed = given(cams::kSpeed);                ///< omega, rad/s
  T inertia = given(cams::kInertia);                    ///< J, kg m^2, of all that swings
  T spring_rate = given(cams::kArmSpringRate);          ///< c, N m/rad
  T spring_preload = given(cams::kArmSpringPreload);    ///< M_0, N m
  T load = given(cams::kArmLoad);                       ///< M_L, N m
  T face_width = given(cams::kFaceWidth);               ///< b, m
  T youngs_modulus = given(cams::kYoungsModulus);       ///< E, Pa
  T poisson_ratio = given(cams::kPoissonRatio);         ///< nu
  T cutter_radius = given(cams::kCutterRadius);         ///< r_c, m
  T density = given(cams::kDensity);                    ///< rho, kg/m^3, of the cam
  T bore_radius = given(cams::kBoreRadius);             ///< r_0, m
  T train_stiffness = given(cams::kArmTrainStiffness);  ///< c_t, N m/rad
  T train_damping = given(cams::kTrainDamping);         ///< zeta
  T end_share = given(cams::kArmEndShare);              ///< kappa, of what moves
  RollerDuty<T> duty = RollerDuty<T>::given_by(given);

  T prime_radius() const { return base_radius + roller_radius; }
  /// (M13) cos psi_0 = (l^2 + d^2 - r_p^2) / (2 l d).
  T cos_lowest() const {
    const T rp = prime_radius();
    return (arm_length * arm_length + pivot_distance * pivot_distance - rp * rp) /
           (number<T>(2) * arm_length * pivot_distance);
  }
  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{prime_radius(), "base_radius + roller_radius must be above 0"},
         {arm_length + pivot_distance - prime_radius(),
          "base_radius + roller_radius must be below arm_length + pivot_distance"},
         {prime_radius() - absolute(T(arm_length - pivot_distance)),
          "base_radius + roller_radius must be above the difference of arm_length and "
          "pivot_distance"}});
  }
  T lowest_angle() const {
    using std::asin;
    return pi<T>() / number<T>(2) - asin(cos_lowest());
  }
  /// What swings counts as what slides: J for m, torques for forces.
  FollowerLoad<T> follower() const {
    return {inertia, spring_rate, spring_preload, load, angular_speed};
  }
  RollerContact<T> roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }
  CamBlank<T> blank() const { return {density, bore_radius, face_width}; }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(swing, motion);
  }
  template <class X>
  CamCurve<X> pitch_curve(const FollowerMotion<X>& f) const {
    return arm().pitch_curve(angle(f), f);
  }
  /// (M14) Pressure angle, rad.
  template <class X>
  X pressure_angle(const FollowerMotion<X>& f) const {
    return arm().pressure_angle(angle(f), f);
  }
  /// (M15) Force between roller and cam, N: N = M / (l cos alpha).
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    using std::cos;
    return follower().force(f) / (arm_length * cos(pressure_angle(f)));
  }
  /// What the cam turns under the arm by its own turn, 1 + psi' (RB1): they turn against one
  /// another in the rise.
  template <class X>
  X turning(const FollowerMotion<X>& f) const {
    return f.ds + number<T>(1);
  }

 private:
  RollerArm<T> arm() const { return {arm_length, pivot_distance}; }
  template <class X>
  X angle(const FollowerMotion<X>& f) const {
    return f.s + lowest_angle();
  }
};

}  // namespace camlaw
