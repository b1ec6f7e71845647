// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/guided_follower.h"
#include "machines/contact/hertz.h"
#include "machines/contact/lubricant.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A disc cam with a translating flat-faced follower whose face stands square to its way
/// (docs/theory.md, "Flat face on a disc cam"). Fields in SI units. The pressure angle is 0
/// everywhere.
struct FlatCam {
  Given given = {};
  Expression stroke = given(cams::kStroke);                 ///< h, m
  Expression base_radius = given(cams::kBaseRadius);        ///< r_b, m
  Expression angular_speed = given(cams::kSpeed);           ///< omega, rad/s
  Expression mass = given(cams::kMass);                     ///< m, kg
  Expression spring_rate = given(cams::kSpringRate);        ///< c, N/m
  Expression spring_preload = given(cams::kSpringPreload);  ///< F_0, N
  Expression load = given(cams::kLoad);                     ///< F_L, N
  Expression face_width = given(cams::kFaceWidth);          ///< b, m, along the cam's axis
  Expression youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  Expression density = given(cams::kDensity);               ///< rho, kg/m^3, of the cam
  Expression bore_radius = given(cams::kBoreRadius);        ///< r_0, m
  Expression wear_coefficient =
      given(cams::kWearCoefficient);  ///< k, m^2/N: volume by force and sliding
  Expression guide_friction = given(cams::kGuideFriction);    ///< mu, between follower and guide
  Expression guide_length = given(cams::kGuideLength);        ///< l_g, m
  Expression train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  Expression train_damping = given(cams::kTrainDamping);      ///< zeta
  Expression end_share = given(cams::kEndShare);              ///< kappa, of what moves
  Expression viscosity = given(cams::kViscosity);             ///< eta, Pa s
  Expression pressure_viscosity = given(cams::kPressureViscosity);  ///< alpha, 1/Pa
  Expression roughness = given(cams::kRoughness);                   ///< R_q, m, of both surfaces

  auto conditions() const {
    return std::to_array<Condition>({{base_radius, "base_radius must be above 0"}});
  }
  FollowerLoad follower() const { return {mass, spring_rate, spring_preload, load, angular_speed}; }
  LineContact contact() const { return {youngs_modulus, poisson_ratio}; }
  SlidingGuide guide() const { return {guide_friction, guide_length}; }
  Lubricant lubricant() const { return {viscosity, pressure_viscosity, roughness}; }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// (M11) Where the face touches, m from the follower's axis: s'. The face must reach so far.
  Expression contact_offset(const FollowerMotion& f) const { return f.ds; }
  /// (M44) What friction in the guide takes of the force along the way, signed as s'.
  GuideShares guide_shares(const FollowerMotion& f) const {
    const Expression share = guide().share_beside(contact_offset(f));
    return {share, share};
  }
  /// (M38), (M44) Force between face and cam, N, along the way: F / (1 - q) with the friction in
  /// the guide that the couple of a contact beside the axis makes. NaN where the follower jams.
  Expression contact_force(const FollowerMotion& f) const { return guided_force(*this, f); }
  /// (M39) Torque on the cam's shaft with the guide's friction, N m.
  Expression drive_torque(const FollowerMotion& f) const { return guided_torque(*this, f); }
  /// (M12) Radius of curvature of the profile, m: r_b + s + s''. The cam can be made while it is
  /// above 0; a flat face touches no hollow.
  Expression profile_radius(const FollowerMotion& f) const { return f.s + f.dds + base_radius; }
  /// The profile: p = s' + i (r_b + s), p1 = r_b + s + s''.
  CamPoint profile(const FollowerMotion& f) const {
    return {f.ds, f.s + base_radius, profile_radius(f), 0};
  }
  CamBlank blank() const { return {density, bore_radius, face_width}; }
  /// (RB11) How fast the face slides on the cam, m/s.
  Expression sliding_speed(const FollowerMotion& f) const {
    return angular_speed * (f.s + base_radius);
  }
  /// (RB13) Mean speed of face and cam towards the contact, m/s: omega (r_b + s + 2 s'') / 2. It
  /// is 0 where the contact runs over the face as fast as over the cam, the other way.
  Expression entrainment_speed(const FollowerMotion& f) const {
    return Expression(0.5) * angular_speed * (profile_radius(f) + f.dds);
  }
  /// (RB12) What the profile loses there by turn, m.
  Expression wear(const FollowerMotion& f) const {
    return wear_coefficient / face_width *
           (contact_force(f) * ((f.s + base_radius) / profile_radius(f)));
  }
  Expression contact_stress(const FollowerMotion& f) const {
    return contact().pressure(contact_force(f) / face_width, 1 / profile_radius(f));
  }
  Expression contact_half_width(const FollowerMotion& f) const {
    return contact().half_width(contact_force(f) / face_width, 1 / profile_radius(f));
  }
};

}  // namespace camlaw
