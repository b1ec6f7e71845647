// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
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
  Given<T> given = {};
  T stroke = given(cams::kStroke);               ///< h, m
  T radius = given(cams::kTrackRadius);          ///< R, m, of the middle of the roller's track
  T roller_radius = given(cams::kRollerRadius);  ///< r_r, m
  T angular_speed = given(cams::kSpeed);         ///< omega, rad/s
  T mass = given(cams::kMass);                   ///< m, kg
  T spring_rate = given(cams::kSpringRate.by_default(0));        ///< c, N/m
  T spring_preload = given(cams::kSpringPreload.by_default(0));  ///< F_0, N
  T load = given(cams::kLoad);                                   ///< F_L, N
  T face_width = given(cams::kFaceWidth);                        ///< b, m, of the contact
  T youngs_modulus = given(cams::kYoungsModulus);                ///< E, Pa, of cam and roller
  T poisson_ratio = given(cams::kPoissonRatio);                  ///< nu
  T cutter_radius = given(cams::kCutterRadius);    ///< r_c, m, of the tool that cuts the track
  T guide_friction = given(cams::kGuideFriction);  ///< mu, between follower and guide
  T guide_length = given(cams::kGuideLength);      ///< l_g, m
  T overhang = given(cams::kOverhang);             ///< a, m, of the roller from its guide at s = 0
  T train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  T train_damping = given(cams::kTrainDamping);      ///< zeta
  T end_share = given(cams::kEndShare);              ///< kappa, of what moves
  RollerDuty<T> duty = RollerDuty<T>::given_by(given);

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
