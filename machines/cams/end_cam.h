// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/guided_follower.h"
#include "machines/cams/roller_contact.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// An end (face) or barrel cam with a roller that moves along the cam's axis (docs/theory.md, "End
/// and barrel cams"), developed at the mean radius of the roller's track. Fields in SI units.
///
/// Valid, with friction in the guide, while the roller stays outside it, stroke at most overhang.
template <class T>
struct EndCam {
  T stroke = number<T>(0.020);                    ///< h, m
  T radius = number<T>(0.050);                    ///< R, m, of the middle of the roller's track
  T roller_radius = number<T>(0.010);             ///< r_r, m
  T angular_speed = number<T>(31.4159265358979);  ///< omega, rad/s
  T mass = number<T>(1);                          ///< m, kg
  T spring_rate = number<T>(0);                   ///< c, N/m
  T spring_preload = number<T>(0);                ///< F_0, N
  T load = number<T>(0);                          ///< F_L, N
  T face_width = number<T>(0.015);                ///< b, m, of the contact
  T youngs_modulus = number<T>(2.1e11);           ///< E, Pa, of cam and roller
  T poisson_ratio = number<T>(0.3);               ///< nu
  T cutter_radius = number<T>(0.010);             ///< r_c, m, of the tool that cuts the track
  T guide_friction = number<T>(0);                ///< mu, between follower and guide
  T guide_length = number<T>(0.060);              ///< l_g, m
  T overhang = number<T>(0.040);                  ///< a, m, of the roller from its guide at s = 0
  T train_stiffness = number<T>(0);               ///< c_t, N/m
  T train_damping = number<T>(0.05);              ///< zeta
  T end_share = number<T>(1);                     ///< kappa, of what moves
  RollerDuty<T> duty{};

  auto conditions() const {
    return std::to_array<Condition<T>>({{radius, "radius must be above 0"}});
  }
  FollowerLoad<T> follower() const {
    return {mass, spring_rate, spring_preload, load, angular_speed};
  }
  RollerContact<T> roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }
  SlidingGuide<T> guide() const { return {guide_friction, guide_length}; }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(stroke, motion);
  }
  /// (M17) The roller's centre on the developed cam: w = i s, w1 = R + i s', w2 = i s''. Its
  /// curvature (M4) is k = -s'' / R^2 / (1 + (s' / R)^2)^(3/2), positive where the cam is convex.
  template <class X>
  CamCurve<X> pitch_curve(const FollowerMotion<X>& f) const {
    const X none = number<X>(0);
    return {none, f.s, none + radius, f.ds, none, f.dds};
  }
  /// A point of a curve on the cam, developed: x along the circumference.
  template <class X>
  std::pair<X, X> placed(const CamPoint<X>& p, const X& phi) const {
    return {p.x + radius * phi, p.y};
  }
  /// (M16) Pressure angle, rad: tan alpha = s' / R.
  template <class X>
  X pressure_angle(const FollowerMotion<X>& f) const {
    using std::atan;
    return atan(f.ds / radius);
  }
  /// (M37) What friction in the guide takes of the force along the way. tan alpha = s' / R has the
  /// velocity's sign.
  template <class X>
  GuideShares<X> guide_shares(const FollowerMotion<X>& f) const {
    const X share = guide().share_across(guide_overhang(*this, f), X(f.ds / radius));
    return {share, share};
  }
  /// (M18), (M38) Force between roller and cam, N, signed as the force along the way:
  /// N = F / (cos alpha (1 - q)). NaN where the follower jams.
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    using std::sqrt;
    const X slope = f.ds / radius;
    return guided_force(*this, f) * sqrt(slope * slope + number<T>(1));
  }
  /// (M39) Torque on the cam's shaft with the guide's friction, N m: N cos alpha s'.
  template <class X>
  X drive_torque(const FollowerMotion<X>& f) const {
    return guided_torque(*this, f);
  }
  /// About the roller's axis the cam does not turn (RB1).
  template <class X>
  X turning(const FollowerMotion<X>&) const {
    return number<X>(0);
  }
};

}  // namespace camlaw
