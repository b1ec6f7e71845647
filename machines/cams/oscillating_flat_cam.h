// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/contact/hertz.h"
#include "machines/contact/lubricant.h"
#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// A disc cam with an oscillating flat-faced follower (docs/theory.md, "Flat face on an arm"). The
/// pivot stands at the distance d from the cam's centre, the face at the distance f from the pivot,
/// towards the cam where f is above 0. psi is the angle of the face to the line of centres, psi_0
/// at the lowest place, psi_0 + Psi s at displacement s. Fields in SI units.
/// The cam turns so that its surface runs along the face away from the pivot (a trailing arm); in
/// the rise cam and arm turn opposite ways.
///
/// Valid while r_b + f is less than d and psi stays below a right angle.
struct OscillatingFlatCam {
  Given given = {};
  Expression swing = given(cams::kSwing);             ///< Psi, rad
  Expression base_radius = given(cams::kBaseRadius);  ///< r_b, m
  Expression face_offset =
      given({"face_offset", "f", "mm", "m",
             "distance of the face from the pivot, positive towards the cam", 0, -1e5, 1e5});
  Expression pivot_distance = given(cams::kPivotDistance.by_default(120));  ///< d, m
  Expression angular_speed = given(cams::kSpeed);                           ///< omega, rad/s
  Expression inertia = given(cams::kInertia);                    ///< J, kg m^2, of all that swings
  Expression spring_rate = given(cams::kArmSpringRate);          ///< c, N m/rad
  Expression spring_preload = given(cams::kArmSpringPreload);    ///< M_0, N m
  Expression load = given(cams::kArmLoad);                       ///< M_L, N m
  Expression face_width = given(cams::kFaceWidth);               ///< b, m, along the cam's axis
  Expression youngs_modulus = given(cams::kYoungsModulus);       ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);         ///< nu
  Expression density = given(cams::kDensity);                    ///< rho, kg/m^3, of the cam
  Expression bore_radius = given(cams::kBoreRadius);             ///< r_0, m
  Expression train_stiffness = given(cams::kArmTrainStiffness);  ///< c_t, N m/rad
  Expression train_damping = given(cams::kTrainDamping);         ///< zeta
  Expression end_share = given(cams::kArmEndShare);              ///< kappa, of what moves
  Expression wear_coefficient =
      given(cams::kWearCoefficient);               ///< k, m^2/N: volume by force and sliding
  Expression viscosity = given(cams::kViscosity);  ///< eta, Pa s
  Expression pressure_viscosity = given(cams::kPressureViscosity);  ///< alpha, 1/Pa
  Expression roughness = given(cams::kRoughness);                   ///< R_q, m, of both surfaces

  /// (M19) sin psi_0 = (r_b + f) / d.
  Expression sin_lowest() const { return (base_radius + face_offset) / pivot_distance; }
  Expression lowest_angle() const { return asin(sin_lowest()); }
  /// The last one says that the face stays less than a right angle from the line of centres,
  /// psi_0 + swing < 90 deg, in the form sin psi_0 < cos swing; swing is below half a turn.
  auto conditions() const {
    const Expression side = base_radius + face_offset;
    return std::to_array<Condition>(
        {{base_radius, "base_radius must be above 0"},
         {pivot_distance, "pivot_distance must be above 0"},
         {pivot_distance - absolute(side),
          "base_radius + face_offset must be less in size than pivot_distance"},
         {pivot_distance * cos(swing) - side,
          "asin((base_radius + face_offset) / pivot_distance) + swing must be below 90 deg"}});
  }
  /// What swings counts as what slides: J for m, torques for forces.
  FollowerLoad follower() const {
    return {inertia, spring_rate, spring_preload, load, angular_speed};
  }
  LineContact contact() const { return {youngs_modulus, poisson_ratio}; }
  Lubricant lubricant() const { return {viscosity, pressure_viscosity, roughness}; }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(swing, motion);
  }
  /// (M20) Lever arm of the contact, m along the face from the foot of the pivot:
  /// d cos psi / (1 + psi'). The face must reach from the shortest to the longest.
  Expression contact_lever(const FollowerMotion& f) const {
    return pivot_distance * cos(f.s + lowest_angle()) / rate(f);
  }
  /// (M21) Radius of curvature of the profile, m: d sin psi (1 + 2 psi') / (1 + psi')^2 +
  /// d psi'' cos psi / (1 + psi')^3 - f. The cam can be made while it is above 0. NaN where
  /// 1 + psi' is below 0; it falls without bound before that.
  Expression profile_radius(const FollowerMotion& f) const {
    const Expression psi = f.s + lowest_angle(), turning = rate(f), square = turning * turning;
    const Expression bent = f.dds * cos(psi) / (square * turning);
    const Expression straight = sin(psi) * (f.ds + turning) / square;
    return pivot_distance * (straight + bent) - face_offset;
  }
  /// The profile, the pivot on the x axis: p = d - i f exp(-i psi) - lambda exp(-i psi); it runs
  /// along the face, p1 = rho (1 + psi') exp(-i psi).
  CamPoint profile(const FollowerMotion& f) const {
    const Expression psi = f.s + lowest_angle(), lever = contact_lever(f);
    const Expression c = cos(psi), s = sin(psi);
    const Expression length = profile_radius(f) * rate(f);
    return {pivot_distance - (face_offset * s + lever * c), lever * s - face_offset * c, length * c,
            -(length * s)};
  }
  CamBlank blank() const { return {density, bore_radius, face_width}; }
  /// (M22) Force between face and cam, N: N = M / lambda.
  Expression contact_force(const FollowerMotion& f) const {
    return follower().force(f) / contact_lever(f);
  }
  /// (RB14) How fast the face slides on the cam, m/s.
  Expression sliding_speed(const FollowerMotion& f) const {
    return angular_speed * absolute(slip(f));
  }
  /// (RB13) Mean speed of face and cam towards the contact, m/s.
  Expression entrainment_speed(const FollowerMotion& f) const {
    return angular_speed * (profile_radius(f) * rate(f) - Expression(0.5) * slip(f));
  }
  /// (RB12) What the profile loses there by turn, m.
  Expression wear(const FollowerMotion& f) const {
    return wear_coefficient / face_width *
           (contact_force(f) * (absolute(slip(f)) / (profile_radius(f) * rate(f))));
  }
  Expression contact_stress(const FollowerMotion& f) const {
    return contact().pressure(contact_force(f) / face_width, 1 / profile_radius(f));
  }
  Expression contact_half_width(const FollowerMotion& f) const {
    return contact().half_width(contact_force(f) / face_width, 1 / profile_radius(f));
  }

 private:
  /// (RB14) d sin psi - f (1 + psi'), m: what the face slides by, over the cam.
  Expression slip(const FollowerMotion& f) const {
    return pivot_distance * sin(f.s + lowest_angle()) - face_offset * rate(f);
  }
  /// 1 + psi': how fast the face turns over the cam; NaN below 0, where no cam gives the motion.
  Expression rate(const FollowerMotion& f) const {
    const Expression root = sqrt(f.ds + 1);
    return root * root;
  }
};

}  // namespace camlaw
