// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/contact/hertz.h"
#include "machines/contact/lubricant.h"
#include "machines/model/possibility.h"
#include "numerics/scalar/absolute.h"

namespace camlaw {

/// A disc cam with an oscillating flat-faced follower (docs/theory.md, "Flat face on an arm"). The
/// pivot stands at the distance d from the cam's centre, the face at the distance f from the pivot,
/// towards the cam where f is above 0. psi is the angle of the face to the line of centres, psi_0
/// at the lowest place, psi_0 + Psi s at displacement s. Fields in SI units.
/// The cam turns so that its surface runs along the face away from the pivot (a trailing arm); in
/// the rise cam and arm turn opposite ways.
///
/// Valid while r_b + f is less than d and psi stays below a right angle.
template <class T>
struct OscillatingFlatCam {
  Given<T> given = {};
  T swing = given(cams::kSwing);             ///< Psi, rad
  T base_radius = given(cams::kBaseRadius);  ///< r_b, m
  T face_offset =
      given({"face_offset", "f", "mm", "m",
             "distance of the face from the pivot, positive towards the cam", 0, -1e5, 1e5});
  T pivot_distance = given(cams::kPivotDistance.by_default(120));  ///< d, m
  T angular_speed = given(cams::kSpeed);                           ///< omega, rad/s
  T inertia = given(cams::kInertia);                    ///< J, kg m^2, of all that swings
  T spring_rate = given(cams::kArmSpringRate);          ///< c, N m/rad
  T spring_preload = given(cams::kArmSpringPreload);    ///< M_0, N m
  T load = given(cams::kArmLoad);                       ///< M_L, N m
  T face_width = given(cams::kFaceWidth);               ///< b, m, along the cam's axis
  T youngs_modulus = given(cams::kYoungsModulus);       ///< E, Pa
  T poisson_ratio = given(cams::kPoissonRatio);         ///< nu
  T density = given(cams::kDensity);                    ///< rho, kg/m^3, of the cam
  T bore_radius = given(cams::kBoreRadius);             ///< r_0, m
  T train_stiffness = given(cams::kArmTrainStiffness);  ///< c_t, N m/rad
  T train_damping = given(cams::kTrainDamping);         ///< zeta
  T end_share = given(cams::kArmEndShare);              ///< kappa, of what moves
  T wear_coefficient = given(cams::kWearCoefficient);   ///< k, m^2/N: volume by force and sliding
  T viscosity = given(cams::kViscosity);                ///< eta, Pa s
  T pressure_viscosity = given(cams::kPressureViscosity);  ///< alpha, 1/Pa
  T roughness = given(cams::kRoughness);                   ///< R_q, m, of both surfaces

  /// (M19) sin psi_0 = (r_b + f) / d.
  T sin_lowest() const { return (base_radius + face_offset) / pivot_distance; }
  T lowest_angle() const {
    using std::asin;
    return asin(sin_lowest());
  }
  /// The last one says that the face stays less than a right angle from the line of centres,
  /// psi_0 + swing < 90 deg, in the form sin psi_0 < cos swing; swing is below half a turn.
  auto conditions() const {
    using std::cos;
    const T side = base_radius + face_offset;
    return std::to_array<Condition<T>>(
        {{base_radius, "base_radius must be above 0"},
         {pivot_distance, "pivot_distance must be above 0"},
         {pivot_distance - absolute(side),
          "base_radius + face_offset must be less in size than pivot_distance"},
         {pivot_distance * cos(swing) - side,
          "asin((base_radius + face_offset) / pivot_distance) + swing must be below 90 deg"}});
  }
  /// What swings counts as what slides: J for m, torques for forces.
  FollowerLoad<T> follower() const {
    return {inertia, spring_rate, spring_preload, load, angular_speed};
  }
  LineContact<T> contact() const { return {youngs_modulus, poisson_ratio}; }
  Lubricant<T> lubricant() const { return {viscosity, pressure_viscosity, roughness}; }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(swing, motion);
  }
  /// (M20) Lever arm of the contact, m along the face from the foot of the pivot:
  /// d cos psi / (1 + psi'). The face must reach from the shortest to the longest.
  template <class X>
  X contact_lever(const FollowerMotion<X>& f) const {
    using std::cos;
    return pivot_distance * cos(f.s + lowest_angle()) / rate(f);
  }
  /// (M21) Radius of curvature of the profile, m: d sin psi (1 + 2 psi') / (1 + psi')^2 +
  /// d psi'' cos psi / (1 + psi')^3 - f. The cam can be made while it is above 0. NaN where
  /// 1 + psi' is below 0; it falls without bound before that.
  template <class X>
  X profile_radius(const FollowerMotion<X>& f) const {
    using std::cos;
    using std::sin;
    const X psi = f.s + lowest_angle(), turning = rate(f), square = turning * turning;
    const X bent = f.dds * cos(psi) / (square * turning);
    const X straight = sin(psi) * (f.ds + turning) / square;
    return pivot_distance * (straight + bent) - face_offset;
  }
  /// The profile, the pivot on the x axis: p = d - i f exp(-i psi) - lambda exp(-i psi); it runs
  /// along the face, p1 = rho (1 + psi') exp(-i psi).
  template <class X>
  CamPoint<X> profile(const FollowerMotion<X>& f) const {
    using std::cos;
    using std::sin;
    const X psi = f.s + lowest_angle(), lever = contact_lever(f);
    const X c = cos(psi), s = sin(psi);
    const X length = profile_radius(f) * rate(f);
    return {pivot_distance - (face_offset * s + lever * c), lever * s - face_offset * c, length * c,
            -(length * s)};
  }
  CamBlank<T> blank() const { return {density, bore_radius, face_width}; }
  /// (M22) Force between face and cam, N: N = M / lambda.
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    return follower().force(f) / contact_lever(f);
  }
  /// (RB14) How fast the face slides on the cam, m/s.
  template <class X>
  X sliding_speed(const FollowerMotion<X>& f) const {
    return angular_speed * absolute(slip(f));
  }
  /// (RB13) Mean speed of face and cam towards the contact, m/s.
  template <class X>
  X entrainment_speed(const FollowerMotion<X>& f) const {
    return angular_speed * (profile_radius(f) * rate(f) - number<T>(0.5) * slip(f));
  }
  /// (RB12) What the profile loses there by turn, m.
  template <class X>
  X wear(const FollowerMotion<X>& f) const {
    return wear_coefficient / face_width *
           (contact_force(f) * (absolute(slip(f)) / (profile_radius(f) * rate(f))));
  }
  template <class X>
  X contact_stress(const FollowerMotion<X>& f) const {
    return contact().pressure(contact_force(f) / face_width, number<X>(1) / profile_radius(f));
  }
  template <class X>
  X contact_half_width(const FollowerMotion<X>& f) const {
    return contact().half_width(contact_force(f) / face_width, number<X>(1) / profile_radius(f));
  }

 private:
  /// (RB14) d sin psi - f (1 + psi'), m: what the face slides by, over the cam.
  template <class X>
  X slip(const FollowerMotion<X>& f) const {
    using std::sin;
    return pivot_distance * sin(f.s + lowest_angle()) - face_offset * rate(f);
  }
  /// 1 + psi': how fast the face turns over the cam; NaN below 0, where no cam gives the motion.
  template <class X>
  X rate(const FollowerMotion<X>& f) const {
    using std::sqrt;
    const X root = sqrt(f.ds + number<T>(1));
    return root * root;
  }
};

}  // namespace camlaw
