// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/guided_follower.h"
#include "machines/cams/roller_cam.h"
#include "machines/contact/crowned_roller.h"
#include "machines/model/possibility.h"
#include "numerics/scalar/extremes.h"

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
template <class T>
struct ConjugateCam {
  Given<T> given = {};
  T stroke = given(cams::kStroke);               ///< h, m
  T base_radius = given(cams::kBaseRadius);      ///< r_b, m, of the main cam
  T roller_radius = given(cams::kRollerRadius);  ///< r_r, m, of either roller
  T offset = given(cams::kOffset);               ///< e, m
  T roller_distance =
      given({"roller_distance", "D", "mm", "m",
             "distance between the two rollers, along the carriage's path", 140, 1e-3, 1e5});
  T angular_speed = given(cams::kSpeed);                         ///< omega, rad/s
  T mass = given(cams::kMass);                                   ///< m, kg, of the carriage
  T spring_rate = given(cams::kSpringRate.by_default(0));        ///< c, N/m
  T spring_preload = given(cams::kSpringPreload.by_default(0));  ///< F_0, N
  T load = given(cams::kLoad);                                   ///< F_L, N
  T face_width = given(cams::kFaceWidth);                        ///< b, m, of either contact
  T youngs_modulus = given(cams::kYoungsModulus);                ///< E, Pa
  T poisson_ratio = given(cams::kPoissonRatio);                  ///< nu
  T cutter_radius = given(cams::kCutterRadius);                  ///< r_c, m
  T bore_radius = given(cams::kBoreRadius);                      ///< r_0, m, of either cam
  T guide_friction = given(cams::kGuideFriction);                ///< mu, between carriage and guide
  T guide_length = given(cams::kGuideLength);                    ///< l_g, m
  T overhang = given(cams::kOverhang);               ///< a, m, of the main roller from it at s = 0
  T train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  T train_damping = given(cams::kTrainDamping);      ///< zeta
  T end_share = given(cams::kEndShare);              ///< kappa, of what moves
  T dynamic_rating = given(cams::kDynamicRating);    ///< C, N, of either roller
  T static_rating = given(cams::kStaticRating);      ///< C_0, N
  T speed_limit = given(cams::kSpeedLimit);          ///< n_G, rad/s, of a roller on its pin
  T crown_radius = given(cams::kCrownRadius);        ///< R_c, m, of either roller along its axis
  T viscosity = given(cams::kViscosity);             ///< eta, Pa s
  T pressure_viscosity = given(cams::kPressureViscosity);  ///< alpha, 1/Pa
  T roughness = given(cams::kRoughness);                   ///< R_q, m, of a roller and its cam

  RollerCam<T> main() const { return cam(base_radius, offset); }
  RollerCam<T> second() const { return cam(second_base_radius(), -offset); }
  /// (M29) Least distance of the second roller from the shaft along the way: D - y_0 - h.
  T second_height() const { return roller_distance - main().lowest_height() - stroke; }
  /// (M30) Base radius of the second cam, m: sqrt(e^2 + (D - y_0 - h)^2) - r_r.
  T second_base_radius() const {
    using std::sqrt;
    const T height = second_height();
    return sqrt(offset * offset + height * height) - roller_radius;
  }
  auto conditions() const {
    using std::sqrt;
    // Of an offset beyond the roller's radius this is a constant: the root of one above 0, a
    // nanometre here, has derivatives, the root of 0 has none.
    const T least = number<T>(1e-18);  // m^2
    const T inside = greater_of(roller_radius * roller_radius - offset * offset, least);
    return joined(
        main().conditions(),
        std::to_array<Condition<T>>(
            {{base_radius, "base_radius must be above 0"},
             {second_height(),
              "roller_distance must be above stroke + sqrt((base_radius + roller_radius)^2 - "
              "offset^2)"},
             {second_height() - sqrt(inside),
              "roller_distance must be so far above stroke + sqrt((base_radius + "
              "roller_radius)^2 - offset^2) that the second cam has a base radius"}}));
  }
  FollowerLoad<T> follower() const {
    return {mass, spring_rate, spring_preload, load, angular_speed};
  }
  RollerContact<T> roller() const { return main().roller(); }
  SlidingGuide<T> guide() const { return {guide_friction, guide_length}; }
  /// What either roller bears, and what lubricates it.
  RollerDuty<T> duty() const {
    return {crown_radius, dynamic_rating,     static_rating, speed_limit,
            viscosity,    pressure_viscosity, roughness};
  }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// What the second cam gives its roller: h - s.
  template <class X>
  FollowerMotion<X> second_motion(const FollowerMotion<X>& f) const {
    return {-f.s + stroke, -f.ds, -f.dds, -f.ddds};
  }
  /// The profiles of the two cams, both seen from the frame of the main one.
  template <class X>
  CamPoint<X> profile(const FollowerMotion<X>& f) const {
    return main().pitch_curve(f).inside(roller_radius);
  }
  template <class X>
  CamPoint<X> second_profile(const FollowerMotion<X>& f) const {
    const CamPoint<X> p = second().pitch_curve(second_motion(f)).inside(roller_radius);
    return {-p.x, -p.y, -p.x1, -p.y1};
  }
  /// (M37), and (M45) of the second roller: what friction in the guide takes of a force that the
  /// main cam gives, and of one of the second cam.
  template <class X>
  GuideShares<X> guide_shares(const FollowerMotion<X>& f) const {
    return {main_share(f), second_share(f)};
  }
  /// (M31), (M38) Force between the cam that bears and its roller, N, above 0 where it is the main
  /// one: N = F / (cos alpha (1 - q)). NaN where the carriage jams.
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    const X force = guided_force(*this, f);
    const X of_main = inclined(main().pitch_curve(f));
    const X of_second = inclined(second().pitch_curve(second_motion(f)));
    return force * by_side(force, of_main, of_second);
  }
  /// The same of one of the rollers, N: 0 where the other one bears.
  template <class X>
  X main_force(const FollowerMotion<X>& f) const {
    const X force = greater_of(follower().force(f), number<X>(0));
    const X along_way = is_number(guide_friction, 0) ? force : pressed(force, main_share(f));
    return along_way * inclined(main().pitch_curve(f));
  }
  template <class X>
  X second_force(const FollowerMotion<X>& f) const {
    const X force = greater_of(X(-follower().force(f)), number<X>(0));
    const X along_way = is_number(guide_friction, 0) ? force : pressed(force, X(-second_share(f)));
    return along_way * inclined(second().pitch_curve(second_motion(f)));
  }
  /// (M39) Torque on the cams' shaft with the guide's friction, N m: N cos alpha s'.
  template <class X>
  X drive_torque(const FollowerMotion<X>& f) const {
    return guided_torque(*this, f);
  }
  /// Greatest pressure, Pa, at the cam that bears. NaN where that one is undercut.
  template <class X>
  X contact_stress(const FollowerMotion<X>& f) const {
    const X force = contact_force(f);
    return unless_zero(force, roller().stress(absolute(force), loaded_curvature(f)));
  }
  /// formula(PressedRoller) of the roller on the cam that bears, crowned or not.
  template <class X, class F>
  X of_pressed(const FollowerMotion<X>& f, F formula) const {
    return unless_zero(contact_force(f), X(formula(loaded_roller(f))));
  }
  /// Between that roller and its cam.
  template <class X>
  RollerFilm<T, T, X> film(const FollowerMotion<X>& f) const {
    const X of_main = rolled_way(main().pitch_curve(f), roller_radius);
    const X of_second = rolled_way(second().pitch_curve(second_motion(f)), roller_radius);
    return {duty().lubricant(), loaded_roller(f),
            X(angular_speed * by_side(follower().force(f), of_main, of_second))};
  }

 private:
  template <class X>
  auto loaded_roller(const FollowerMotion<X>& f) const {
    const RollerContact<T> contact = roller();
    return pressed_roller(X(absolute(contact_force(f))),
                          X(contact.curvature_sum(loaded_curvature(f))), duty().crown_curvature(),
                          face_width, contact.material);
  }
  /// Of the pitch curve of the cam that bears, 1/m.
  template <class X>
  X loaded_curvature(const FollowerMotion<X>& f) const {
    const X of_main = main().pitch_curve(f).curvature();
    const X of_second = second().pitch_curve(second_motion(f)).curvature();
    return by_side(follower().force(f), of_main, of_second);
  }
  /// N cos alpha of one roller, whose friction takes so much: what does not press does not jam.
  template <class X>
  X pressed(const X& force, const X& taken) const {
    return unless_zero(force, guide().driving_force(force, taken));
  }
  /// (M37), and (M45) of the second roller, which is D further from the guide.
  template <class X>
  X main_share(const FollowerMotion<X>& f) const {
    return guide().share_across(guide_overhang(*this, f), tangent_of(main().pitch_curve(f), f));
  }
  template <class X>
  X second_share(const FollowerMotion<X>& f) const {
    return guide().share_across(X(guide_overhang(*this, f) + roller_distance),
                                tangent_of(second().pitch_curve(second_motion(f)), f));
  }
  /// |tan alpha| of a roller with the sign of the carriage's velocity.
  template <class X>
  X tangent_of(const CamCurve<X>& w, const FollowerMotion<X>& f) const {
    return is_number(offset, 0) ? X(f.ds / w.y) : along(f.ds, X(w.y1 / w.y));
  }
  RollerCam<T> cam(const T& base, const T& side) const {
    return {Given<T>::unset(), stroke,         base,          roller_radius,  side,
            angular_speed,     mass,           spring_rate,   spring_preload, load,
            face_width,        youngs_modulus, poisson_ratio, cutter_radius};
  }
  /// 1 / cos alpha.
  template <class X>
  static X inclined(const CamCurve<X>& w) {
    return w.speed() / w.y;
  }
};

}  // namespace camlaw
