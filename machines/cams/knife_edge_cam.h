// SPDX-License-Identifier: MIT
#pragma once

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
  T stroke = number<T>(0.020);                    ///< h, m
  T base_radius = number<T>(0.040);               ///< r_b, m
  T offset = number<T>(0);                        ///< e, m
  T angular_speed = number<T>(31.4159265358979);  ///< omega, rad/s
  T mass = number<T>(1);                          ///< m, kg
  T spring_rate = number<T>(5000);                ///< c, N/m
  T spring_preload = number<T>(50);               ///< F_0, N
  T load = number<T>(0);                          ///< F_L, N
  T cutter_radius = number<T>(0.010);             ///< r_c, m, of the tool that cuts the profile
  T face_width = number<T>(0.015);                ///< b, m, of the cam
  T density = number<T>(7850);                    ///< rho, kg/m^3, of the cam
  T bore_radius = number<T>(0.010);               ///< r_0, m
  T wear_coefficient = number<T>(1e-16);          ///< k, m^2/N: volume by force and sliding
  T guide_friction = number<T>(0);                ///< mu, between follower and guide
  T guide_length = number<T>(0.060);              ///< l_g, m
  T overhang = number<T>(0.040);                  ///< a, m, of the edge from its guide at s = 0
  T train_stiffness = number<T>(0);               ///< c_t, N/m
  T train_damping = number<T>(0.05);              ///< zeta
  T end_share = number<T>(1);                     ///< kappa, of what moves

  /// The cam with a roller of no radius; its contact is not meant.
  RollerCam<T> edge() const {
    return {.stroke = stroke,
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
