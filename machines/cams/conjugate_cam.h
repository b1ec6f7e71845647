// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/guided_follower.h"
#include "machines/cams/roller_cam.h"
#include "machines/contact/crowned_roller.h"
#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// Two disc cams on one shaft that move a translating carriage both ways (docs/theory.md,
/// "Conjugate cams"). Its two rollers are alike, on opposite sides of the shaft, the distance D
/// apart along the carriage's path. The main cam is a RollerCam; the second one is a RollerCam of
/// the complementary motion, seen from the other side. Fields in SI units.
///
/// Valid while the second roller stays beyond the shaft and its cam has a base radius above 0, for
/// programs between displacement 0 and 1. The pair runs without play and without bracing: where
/// one cam bears, the other does not. The guide lies beyond the main roller; with friction in it
/// that roller must stay outside, stroke at most overhang.
struct ConjugateCam {
  Given given = {};
  Expression stroke = given(cams::kStroke);               ///< h, m
  Expression base_radius = given(cams::kBaseRadius);      ///< r_b, m, of the main cam
  Expression roller_radius = given(cams::kRollerRadius);  ///< r_r, m, of either roller
  Expression offset = given(cams::kOffset);               ///< e, m
  Expression roller_distance =
      given({"roller_distance", "D", "mm", "m",
             "distance between the two rollers, along the carriage's path", 140, 1e-3, 1e5});
  Expression angular_speed = given(cams::kSpeed);                   ///< omega, rad/s
  Expression mass = given(cams::kMass);                             ///< m, kg, of the carriage
  Expression spring_rate = given(cams::kSpringRate.by_default(0));  ///< c, N/m
  Expression spring_preload = given(cams::kSpringPreload.by_default(0));  ///< F_0, N
  Expression load = given(cams::kLoad);                                   ///< F_L, N
  Expression face_width = given(cams::kFaceWidth);          ///< b, m, of either contact
  Expression youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  Expression cutter_radius = given(cams::kCutterRadius);    ///< r_c, m
  Expression bore_radius = given(cams::kBoreRadius);        ///< r_0, m, of either cam
  Expression guide_friction = given(cams::kGuideFriction);  ///< mu, between carriage and guide
  Expression guide_length = given(cams::kGuideLength);      ///< l_g, m
  Expression overhang = given(cams::kOverhang);  ///< a, m, of the main roller from it at s = 0
  Expression train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  Expression train_damping = given(cams::kTrainDamping);      ///< zeta
  Expression end_share = given(cams::kEndShare);              ///< kappa, of what moves
  Expression dynamic_rating = given(cams::kDynamicRating);    ///< C, N, of either roller
  Expression static_rating = given(cams::kStaticRating);      ///< C_0, N
  Expression speed_limit = given(cams::kSpeedLimit);    ///< n_G, rad/s, of a roller on its pin
  Expression crown_radius = given(cams::kCrownRadius);  ///< R_c, m, of either roller along its axis
  Expression viscosity = given(cams::kViscosity);       ///< eta, Pa s
  Expression pressure_viscosity = given(cams::kPressureViscosity);  ///< alpha, 1/Pa
  Expression roughness = given(cams::kRoughness);  ///< R_q, m, of a roller and its cam

  RollerCam main() const { return cam(base_radius, offset); }
  RollerCam second() const { return cam(second_base_radius(), -offset); }
  /// (M29) Least distance of the second roller from the shaft along the way: D - y_0 - h.
  Expression second_height() const { return roller_distance - main().lowest_height() - stroke; }
  /// (M30) Base radius of the second cam, m: sqrt(e^2 + (D - y_0 - h)^2) - r_r.
  Expression second_base_radius() const {
    const Expression height = second_height();
    return sqrt(offset * offset + height * height) - roller_radius;
  }
  auto conditions() const {
    // Of an offset beyond the roller's radius this is a constant: the root of one above 0, a
    // nanometre here, has derivatives, the root of 0 has none.
    const Expression least = Expression(1e-18);  // m^2
    const Expression inside = greater_of(roller_radius * roller_radius - offset * offset, least);
    return joined(
        main().conditions(),
        std::to_array<Condition>(
            {{base_radius, "base_radius must be above 0"},
             {second_height(),
              "roller_distance must be above stroke + sqrt((base_radius + roller_radius)^2 - "
              "offset^2)"},
             {second_height() - sqrt(inside),
              "roller_distance must be so far above stroke + sqrt((base_radius + "
              "roller_radius)^2 - offset^2) that the second cam has a base radius"}}));
  }
  FollowerLoad follower() const { return {mass, spring_rate, spring_preload, load, angular_speed}; }
  RollerContact roller() const { return main().roller(); }
  SlidingGuide guide() const { return {guide_friction, guide_length}; }
  /// What either roller bears, and what lubricates it.
  RollerDuty duty() const {
    return {crown_radius, dynamic_rating,     static_rating, speed_limit,
            viscosity,    pressure_viscosity, roughness};
  }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// What the second cam gives its roller: h - s.
  FollowerMotion second_motion(const FollowerMotion& f) const {
    return {-f.s + stroke, -f.ds, -f.dds, -f.ddds};
  }
  /// The profiles of the two cams, both seen from the frame of the main one.
  CamPoint profile(const FollowerMotion& f) const {
    return main().pitch_curve(f).inside(roller_radius);
  }
  CamPoint second_profile(const FollowerMotion& f) const {
    const CamPoint p = second().pitch_curve(second_motion(f)).inside(roller_radius);
    return {-p.x, -p.y, -p.x1, -p.y1};
  }
  /// (M37), and (M45) of the second roller: what friction in the guide takes of a force that the
  /// main cam gives, and of one of the second cam.
  GuideShares guide_shares(const FollowerMotion& f) const {
    return {main_share(f), second_share(f)};
  }
  /// (M31), (M38) Force between the cam that bears and its roller, N, above 0 where it is the main
  /// one: N = F / (cos alpha (1 - q)). NaN where the carriage jams.
  Expression contact_force(const FollowerMotion& f) const {
    const Expression force = guided_force(*this, f);
    const Expression of_main = inclined(main().pitch_curve(f));
    const Expression of_second = inclined(second().pitch_curve(second_motion(f)));
    return force * by_side(force, of_main, of_second);
  }
  /// The same of one of the rollers, N: 0 where the other one bears.
  Expression main_force(const FollowerMotion& f) const {
    const Expression force = greater_of(follower().force(f), 0);
    const Expression along_way =
        is_number(guide_friction, 0) ? force : pressed(force, main_share(f));
    return along_way * inclined(main().pitch_curve(f));
  }
  Expression second_force(const FollowerMotion& f) const {
    const Expression force = greater_of(-follower().force(f), 0);
    const Expression along_way =
        is_number(guide_friction, 0) ? force : pressed(force, -second_share(f));
    return along_way * inclined(second().pitch_curve(second_motion(f)));
  }
  /// (M39) Torque on the cams' shaft with the guide's friction, N m: N cos alpha s'.
  Expression drive_torque(const FollowerMotion& f) const { return guided_torque(*this, f); }
  /// Greatest pressure, Pa, at the cam that bears. NaN where that one is undercut.
  Expression contact_stress(const FollowerMotion& f) const {
    const Expression force = contact_force(f);
    return unless_zero(force, roller().stress(absolute(force), loaded_curvature(f)));
  }
  /// formula(PressedRoller) of the roller on the cam that bears, crowned or not.
  template <class F>
  Expression of_pressed(const FollowerMotion& f, F formula) const {
    return unless_zero(contact_force(f), formula(loaded_roller(f)));
  }
  /// Between that roller and its cam.
  RollerFilm film(const FollowerMotion& f) const {
    const Expression of_main = rolled_way(main().pitch_curve(f), roller_radius);
    const Expression of_second = rolled_way(second().pitch_curve(second_motion(f)), roller_radius);
    return {duty().lubricant(), loaded_roller(f),
            angular_speed * by_side(follower().force(f), of_main, of_second)};
  }

 private:
  PressedRoller loaded_roller(const FollowerMotion& f) const {
    const RollerContact contact = roller();
    return pressed_roller(absolute(contact_force(f)), contact.curvature_sum(loaded_curvature(f)),
                          duty().crown_curvature(), face_width, contact.material);
  }
  /// Of the pitch curve of the cam that bears, 1/m.
  Expression loaded_curvature(const FollowerMotion& f) const {
    const Expression of_main = main().pitch_curve(f).curvature();
    const Expression of_second = second().pitch_curve(second_motion(f)).curvature();
    return by_side(follower().force(f), of_main, of_second);
  }
  /// N cos alpha of one roller, whose friction takes so much: what does not press does not jam.
  Expression pressed(const Expression& force, const Expression& taken) const {
    return unless_zero(force, guide().driving_force(force, taken));
  }
  /// (M37), and (M45) of the second roller, which is D further from the guide.
  Expression main_share(const FollowerMotion& f) const {
    return guide().share_across(guide_overhang(*this, f), tangent_of(main().pitch_curve(f), f));
  }
  Expression second_share(const FollowerMotion& f) const {
    return guide().share_across(guide_overhang(*this, f) + roller_distance,
                                tangent_of(second().pitch_curve(second_motion(f)), f));
  }
  /// |tan alpha| of a roller with the sign of the carriage's velocity.
  Expression tangent_of(const CamCurve& w, const FollowerMotion& f) const {
    return is_number(offset, 0) ? f.ds / w.y : along(f.ds, w.y1 / w.y);
  }
  RollerCam cam(const Expression& base, const Expression& side) const {
    return {Given::unset(), stroke,         base,          roller_radius,  side,
            angular_speed,  mass,           spring_rate,   spring_preload, load,
            face_width,     youngs_modulus, poisson_ratio, cutter_radius};
  }
  /// 1 / cos alpha.
  static Expression inclined(const CamCurve& w) { return w.speed() / w.y; }
};

}  // namespace camlaw
