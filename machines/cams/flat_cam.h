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
template <class T>
struct FlatCam {
  Given<T> given = {};
  T stroke = given(cams::kStroke);                     ///< h, m
  T base_radius = given(cams::kBaseRadius);            ///< r_b, m
  T angular_speed = given(cams::kSpeed);               ///< omega, rad/s
  T mass = given(cams::kMass);                         ///< m, kg
  T spring_rate = given(cams::kSpringRate);            ///< c, N/m
  T spring_preload = given(cams::kSpringPreload);      ///< F_0, N
  T load = given(cams::kLoad);                         ///< F_L, N
  T face_width = given(cams::kFaceWidth);              ///< b, m, along the cam's axis
  T youngs_modulus = given(cams::kYoungsModulus);      ///< E, Pa
  T poisson_ratio = given(cams::kPoissonRatio);        ///< nu
  T density = given(cams::kDensity);                   ///< rho, kg/m^3, of the cam
  T bore_radius = given(cams::kBoreRadius);            ///< r_0, m
  T wear_coefficient = given(cams::kWearCoefficient);  ///< k, m^2/N: volume by force and sliding
  T guide_friction = given(cams::kGuideFriction);      ///< mu, between follower and guide
  T guide_length = given(cams::kGuideLength);          ///< l_g, m
  T train_stiffness = given(cams::kTrainStiffness);    ///< c_t, N/m
  T train_damping = given(cams::kTrainDamping);        ///< zeta
  T end_share = given(cams::kEndShare);                ///< kappa, of what moves
  T viscosity = given(cams::kViscosity);               ///< eta, Pa s
  T pressure_viscosity = given(cams::kPressureViscosity);  ///< alpha, 1/Pa
  T roughness = given(cams::kRoughness);                   ///< R_q, m, of both surfaces

  auto conditions() const {
    return std::to_array<Condition<T>>({{base_radius, "base_radius must be above 0"}});
  }
  FollowerLoad<T> follower() const {
    return {mass, spring_rate, spring_preload, load, angular_speed};
  }
  LineContact<T> contact() const { return {youngs_modulus, poisson_ratio}; }
  SlidingGuide<T> guide() const { return {guide_friction, guide_length}; }
  Lubricant<T> lubricant() const { return {viscosity, pressure_viscosity, roughness}; }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// (M11) Where the face touches, m from the follower's axis: s'. The face must reach so far.
  template <class X>
  X contact_offset(const FollowerMotion<X>& f) const {
    return f.ds;
  }
  /// (M44) What friction in the guide takes of the force along the way, signed as s'.
  template <class X>
  GuideShares<X> guide_shares(const FollowerMotion<X>& f) const {
    const X share = guide().share_beside(contact_offset(f));
    return {share, share};
  }
  /// (M38), (M44) Force between face and cam, N, along the way: F / (1 - q) with the friction in
  /// the guide that the couple of a contact beside the axis makes. NaN where the follower jams.
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    return guided_force(*this, f);
  }
  /// (M39) Torque on the cam's shaft with the guide's friction, N m.
  template <class X>
  X drive_torque(const FollowerMotion<X>& f) const {
    return guided_torque(*this, f);
  }
  /// (M12) Radius of curvature of the profile, m: r_b + s + s''. The cam can be made while it is
  /// above 0; a flat face touches no hollow.
  template <class X>
  X profile_radius(const FollowerMotion<X>& f) const {
    return f.s + f.dds + base_radius;
  }
  /// The profile: p = s' + i (r_b + s), p1 = r_b + s + s''.
  template <class X>
  CamPoint<X> profile(const FollowerMotion<X>& f) const {
    return {f.ds, f.s + base_radius, profile_radius(f), number<X>(0)};
  }
  CamBlank<T> blank() const { return {density, bore_radius, face_width}; }
  /// (RB11) How fast the face slides on the cam, m/s.
  template <class X>
  X sliding_speed(const FollowerMotion<X>& f) const {
    return angular_speed * (f.s + base_radius);
  }
  /// (RB13) Mean speed of face and cam towards the contact, m/s: omega (r_b + s + 2 s'') / 2. It
  /// is 0 where the contact runs over the face as fast as over the cam, the other way.
  template <class X>
  X entrainment_speed(const FollowerMotion<X>& f) const {
    return number<T>(0.5) * angular_speed * (profile_radius(f) + f.dds);
  }
  /// (RB12) What the profile loses there by turn, m.
  template <class X>
  X wear(const FollowerMotion<X>& f) const {
    return wear_coefficient / face_width *
           (contact_force(f) * ((f.s + base_radius) / profile_radius(f)));
  }
  template <class X>
  X contact_stress(const FollowerMotion<X>& f) const {
    return contact().pressure(contact_force(f) / face_width, number<X>(1) / profile_radius(f));
  }
  template <class X>
  X contact_half_width(const FollowerMotion<X>& f) const {
    return contact().half_width(contact_force(f) / face_width, number<X>(1) / profile_radius(f));
  }
};

}  // namespace camlaw
