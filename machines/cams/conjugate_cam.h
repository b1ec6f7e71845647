// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
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
  T stroke = number<T>(0.020);                    ///< h, m
  T base_radius = number<T>(0.040);               ///< r_b, m, of the main cam
  T roller_radius = number<T>(0.010);             ///< r_r, m, of either roller
  T offset = number<T>(0);                        ///< e, m
  T roller_distance = number<T>(0.140);           ///< D, m
  T angular_speed = number<T>(31.4159265358979);  ///< omega, rad/s
  T mass = number<T>(1);                          ///< m, kg, of the carriage
  T spring_rate = number<T>(0);                   ///< c, N/m
  T spring_preload = number<T>(0);                ///< F_0, N
  T load = number<T>(0);                          ///< F_L, N
  T face_width = number<T>(0.015);                ///< b, m, of either contact
  T youngs_modulus = number<T>(2.1e11);           ///< E, Pa
  T poisson_ratio = number<T>(0.3);               ///< nu
  T cutter_radius = number<T>(0.010);             ///< r_c, m
  T bore_radius = number<T>(0.010);               ///< r_0, m, of either cam
  T guide_friction = number<T>(0);                ///< mu, between carriage and guide
  T guide_length = number<T>(0.060);              ///< l_g, m
  T overhang = number<T>(0.040);                  ///< a, m, of the main roller from it at s = 0
  T train_stiffness = number<T>(0);               ///< c_t, N/m
  T train_damping = number<T>(0.05);              ///< zeta
  T end_share = number<T>(1);                     ///< kappa, of what moves
  T dynamic_rating = number<T>(1e4);              ///< C, N, of either roller
  T static_rating = number<T>(1e4);               ///< C_0, N
  T speed_limit = number<T>(628.3185307179587);   ///< n_G, rad/s, of a roller on its pin
  T crown_radius = number<T>(0.5);                ///< R_c, m, of either roller along its axis

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
  /// What either roller bears; the pair has no lubricant.
  RollerDuty<T> duty() const {
    RollerDuty<T> result;
    result.crown_radius = crown_radius;
    result.dynamic_rating = dynamic_rating;
    result.static_rating = static_rating;
    result.speed_limit = speed_limit;
    return result;
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
  /// Of the roller on the cam that bears, crowned or not.
  template <class X>
  X crown(CrownCurve which, const FollowerMotion<X>& f) const {
    const X force = contact_force(f);
    const RollerContact<T> contact = roller();
    return unless_zero(
        force,
        crown_curve(which,
                    pressed_roller(X(absolute(force)), contact.curvature_sum(loaded_curvature(f)),
                                   duty().crown_curvature(), face_width, contact.material)));
  }

 private:
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
    return {stroke,         base,          roller_radius,  side, angular_speed,
            mass,           spring_rate,   spring_preload, load, face_width,
            youngs_modulus, poisson_ratio, cutter_radius};
  }
  /// 1 / cos alpha.
  template <class X>
  static X inclined(const CamCurve<X>& w) {
    return w.speed() / w.y;
  }
};

}  // namespace camlaw
