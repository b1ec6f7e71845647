// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_parameters.h"
#include "machines/cams/roller_cam.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A disc cam with a translating knife-edged follower, offset or in line (docs/theory.md, "Roller
/// on a disc cam"): a roller of radius 0, whose pitch curve is the profile. Fields in SI units. An
/// edge has no line contact, so no Hertz stress.
///
/// Valid while |offset| is less than the base radius.
template <class T>
struct KnifeEdgeCam {
  Given<T> given = {};
  T stroke = given(cams::kStroke);                 ///< h, m
  T base_radius = given(cams::kBaseRadius);        ///< r_b, m
  T offset = given(cams::kOffset);                 ///< e, m
  T angular_speed = given(cams::kSpeed);           ///< omega, rad/s
  T mass = given(cams::kMass);                     ///< m, kg
  T spring_rate = given(cams::kSpringRate);        ///< c, N/m
  T spring_preload = given(cams::kSpringPreload);  ///< F_0, N
  T load = given(cams::kLoad);                     ///< F_L, N
  T cutter_radius = given(cams::kCutterRadius);    ///< r_c, m, of the tool that cuts the profile
  T face_width = given(cams::kFaceWidth.meaning_that("width of the cam"));  ///< b, m, of the cam
  T density = given(cams::kDensity);                   ///< rho, kg/m^3, of the cam
  T bore_radius = given(cams::kBoreRadius);            ///< r_0, m
  T wear_coefficient = given(cams::kWearCoefficient);  ///< k, m^2/N: volume by force and sliding
  T guide_friction = given(cams::kGuideFriction);      ///< mu, between follower and guide
  T guide_length = given(cams::kGuideLength);          ///< l_g, m
  T overhang = given(cams::kOverhang);               ///< a, m, of the edge from its guide at s = 0
  T train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  T train_damping = given(cams::kTrainDamping);      ///< zeta
  T end_share = given(cams::kEndShare);              ///< kappa, of what moves

  /// The cam with a roller of no radius; its contact is not meant.
  RollerCam<T> edge() const {
    return {.given = Given<T>::unset(),
            .stroke = stroke,
            .base_radius = base_radius,
            .roller_radius = number<T>(0),
            .offset = offset,
            .angular_speed = angular_speed,
            .mass = mass,
            .spring_rate = spring_rate,
            .spring_preload = spring_preload,
            .load = load,
            .cutter_radius = cutter_radius,
            .guide_friction = guide_friction,
            .guide_length = guide_length,
            .overhang = overhang};
  }
  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{base_radius, "base_radius must be above 0"},
         {base_radius - absolute(offset), "offset must be less in size than base_radius"}});
  }
  CamBlank<T> blank() const { return {density, bore_radius, face_width}; }
  FollowerLoad<T> follower() const { return edge().follower(); }
  SlidingGuide<T> guide() const { return edge().guide(); }
  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// The edge on the cam: the profile.
  template <class X>
  CamCurve<X> pitch_curve(const FollowerMotion<X>& f) const {
    return edge().pitch_curve(f);
  }
  /// The profile, and the middle of the tool that cuts it.
  template <class X>
  CamPoint<X> profile(const FollowerMotion<X>& f) const {
    return pitch_curve(f).inside(number<T>(0));
  }
  template <class X>
  CamPoint<X> cutter(const FollowerMotion<X>& f) const {
    return pitch_curve(f).inside(-cutter_radius);
  }
  /// (M6) Pressure angle, rad.
  template <class X>
  X pressure_angle(const FollowerMotion<X>& f) const {
    return edge().pressure_angle(f);
  }
  /// (M37) What friction in the guide takes of the force along the way.
  template <class X>
  GuideShares<X> guide_shares(const FollowerMotion<X>& f) const {
    return edge().guide_shares(f);
  }
  /// (M39) Torque on the cam's shaft with the guide's friction, N m.
  template <class X>
  X drive_torque(const FollowerMotion<X>& f) const {
    return edge().drive_torque(f);
  }
  /// (M9), (M38) Force between edge and cam, N.
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    return edge().contact_force(f);
  }
  /// (RB11) How fast the edge slides on the cam, m/s: as it runs along the profile.
  template <class X>
  X sliding_speed(const FollowerMotion<X>& f) const {
    return angular_speed * pitch_curve(f).speed();
  }
  /// (RB12) What the profile loses there by turn, m.
  template <class X>
  X wear(const FollowerMotion<X>& f) const {
    return wear_coefficient / face_width * contact_force(f);
  }
  /// (M4) Curvature of the profile, 1/m; where it goes below 0 the profile turns hollow.
  template <class X>
  X profile_curvature(const FollowerMotion<X>& f) const {
    return pitch_curve(f).curvature();
  }
  /// Share of a hollow's radius that the tool takes; above 1 it does not fit.
  template <class X>
  X tool_fit(const FollowerMotion<X>& f) const {
    return edge().roller().tool_fit(profile_curvature(f));
  }
};

}  // namespace camlaw
