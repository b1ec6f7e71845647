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
struct KnifeEdgeCam {
  Given given = {};
  Expression stroke = given(cams::kStroke);                 ///< h, m
  Expression base_radius = given(cams::kBaseRadius);        ///< r_b, m
  Expression offset = given(cams::kOffset);                 ///< e, m
  Expression angular_speed = given(cams::kSpeed);           ///< omega, rad/s
  Expression mass = given(cams::kMass);                     ///< m, kg
  Expression spring_rate = given(cams::kSpringRate);        ///< c, N/m
  Expression spring_preload = given(cams::kSpringPreload);  ///< F_0, N
  Expression load = given(cams::kLoad);                     ///< F_L, N
  Expression cutter_radius =
      given(cams::kCutterRadius);  ///< r_c, m, of the tool that cuts the profile
  Expression face_width =
      given(cams::kFaceWidth.meaning_that("width of the cam"));  ///< b, m, of the cam
  Expression density = given(cams::kDensity);                    ///< rho, kg/m^3, of the cam
  Expression bore_radius = given(cams::kBoreRadius);             ///< r_0, m
  Expression wear_coefficient =
      given(cams::kWearCoefficient);  ///< k, m^2/N: volume by force and sliding
  Expression guide_friction = given(cams::kGuideFriction);  ///< mu, between follower and guide
  Expression guide_length = given(cams::kGuideLength);      ///< l_g, m
  Expression overhang = given(cams::kOverhang);  ///< a, m, of the edge from its guide at s = 0
  Expression train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  Expression train_damping = given(cams::kTrainDamping);      ///< zeta
  Expression end_share = given(cams::kEndShare);              ///< kappa, of what moves

  /// The cam with a roller of no radius; its contact is not meant.
  RollerCam edge() const {
    return {.given = Given::unset(),
            .stroke = stroke,
            .base_radius = base_radius,
            .roller_radius = 0,
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
    return std::to_array<Condition>(
        {{base_radius, "base_radius must be above 0"},
         {base_radius - absolute(offset), "offset must be less in size than base_radius"}});
  }
  CamBlank blank() const { return {density, bore_radius, face_width}; }
  FollowerLoad follower() const { return edge().follower(); }
  SlidingGuide guide() const { return edge().guide(); }
  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// The edge on the cam: the profile.
  CamCurve pitch_curve(const FollowerMotion& f) const { return edge().pitch_curve(f); }
  /// The profile, and the middle of the tool that cuts it.
  CamPoint profile(const FollowerMotion& f) const { return pitch_curve(f).inside(0); }
  CamPoint cutter(const FollowerMotion& f) const { return pitch_curve(f).inside(-cutter_radius); }
  /// (M6) Pressure angle, rad.
  Expression pressure_angle(const FollowerMotion& f) const { return edge().pressure_angle(f); }
  /// (M37) What friction in the guide takes of the force along the way.
  GuideShares guide_shares(const FollowerMotion& f) const { return edge().guide_shares(f); }
  /// (M39) Torque on the cam's shaft with the guide's friction, N m.
  Expression drive_torque(const FollowerMotion& f) const { return edge().drive_torque(f); }
  /// (M9), (M38) Force between edge and cam, N.
  Expression contact_force(const FollowerMotion& f) const { return edge().contact_force(f); }
  /// (RB11) How fast the edge slides on the cam, m/s: as it runs along the profile.
  Expression sliding_speed(const FollowerMotion& f) const {
    return angular_speed * pitch_curve(f).speed();
  }
  /// (RB12) What the profile loses there by turn, m.
  Expression wear(const FollowerMotion& f) const {
    return wear_coefficient / face_width * contact_force(f);
  }
  /// (M4) Curvature of the profile, 1/m; where it goes below 0 the profile turns hollow.
  Expression profile_curvature(const FollowerMotion& f) const { return pitch_curve(f).curvature(); }
  /// Share of a hollow's radius that the tool takes; above 1 it does not fit.
  Expression tool_fit(const FollowerMotion& f) const {
    return edge().roller().tool_fit(profile_curvature(f));
  }
};

}  // namespace camlaw
