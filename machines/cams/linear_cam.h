// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_parameters.h"
#include "machines/cams/end_cam.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A plate that slides evenly by its travel L in a cycle under a translating roller follower, whose
/// way is square to the plate's (docs/theory.md, "Cam plates"): a developed end cam of the
/// radius L / (2 pi). Fields in SI units. Radians are of the cycle, 2 pi each.
///
/// Valid for one passage of the plate, or one that repeats; what a plate does that stops and comes
/// back is another cycle. With friction in the guide, while the roller stays outside it.
template <class T>
struct LinearCam {
  Given<T> given = {};
  T stroke = given(cams::kStroke);  ///< h, m
  T travel = given({"travel", "L", "mm", "m", "travel of the plate in a cycle", 300, 1e-3, 1e6});
  T roller_radius = given(cams::kRollerRadius);  ///< r_r, m
  T angular_speed = given(cams::kSpeed.meaning_that(
      "cycles of the plate per minute"));          ///< omega, rad/s, 2 pi by cycle
  T mass = given(cams::kMass);                     ///< m, kg
  T spring_rate = given(cams::kSpringRate);        ///< c, N/m
  T spring_preload = given(cams::kSpringPreload);  ///< F_0, N
  T load = given(cams::kLoad);                     ///< F_L, N
  T face_width = given(cams::kFaceWidth);          ///< b, m, of the contact
  T youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa, of plate and roller
  T poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  T cutter_radius = given(cams::kCutterRadius);    ///< r_c, m, of the tool that cuts the profile
  T guide_friction = given(cams::kGuideFriction);  ///< mu, between follower and guide
  T guide_length = given(cams::kGuideLength);      ///< l_g, m
  T overhang = given(cams::kOverhang);             ///< a, m, of the roller from its guide at s = 0
  T train_stiffness = given(cams::kTrainStiffness);  ///< c_t, N/m
  T train_damping = given(cams::kTrainDamping);      ///< zeta
  T end_share = given(cams::kEndShare);              ///< kappa, of what moves
  RollerDuty<T> duty = RollerDuty<T>::given_by(given);

  auto conditions() const {
    return std::to_array<Condition<T>>({{travel, "travel must be above 0"}});
  }
  /// Way of the plate by radian.
  T radius() const { return travel / (number<T>(2) * pi<T>()); }
  EndCam<T> developed() const {
    return {Given<T>::unset(), stroke,         radius(),
            roller_radius,     angular_speed,  mass,
            spring_rate,       spring_preload, load,
            face_width,        youngs_modulus, poisson_ratio,
            cutter_radius,     guide_friction, guide_length,
            overhang};
  }
  FollowerLoad<T> follower() const { return developed().follower(); }
  RollerContact<T> roller() const { return developed().roller(); }
  SlidingGuide<T> guide() const { return developed().guide(); }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return developed().over_angle(motion);
  }
  /// The roller's centre on the plate.
  template <class X>
  CamCurve<X> pitch_curve(const FollowerMotion<X>& f) const {
    return developed().pitch_curve(f);
  }
  template <class X>
  std::pair<X, X> placed(const CamPoint<X>& p, const X& phi) const {
    return developed().placed(p, phi);
  }
  /// (M16) Pressure angle, rad: tan alpha = s' / R.
  template <class X>
  X pressure_angle(const FollowerMotion<X>& f) const {
    return developed().pressure_angle(f);
  }
  /// (M37) What friction in the guide takes of the force along the way.
  template <class X>
  GuideShares<X> guide_shares(const FollowerMotion<X>& f) const {
    return developed().guide_shares(f);
  }
  /// (M18), (M38) Force between roller and plate, N: N = F / (cos alpha (1 - q)).
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    return developed().contact_force(f);
  }
  /// (M39) What stands for the torque on a shaft, N m: the plate's force by its way per radian.
  template <class X>
  X drive_torque(const FollowerMotion<X>& f) const {
    return developed().drive_torque(f);
  }
  /// (M26) Force that moves the plate, N: P = N sin alpha.
  template <class X>
  X plate_force(const FollowerMotion<X>& f) const {
    return drive_torque(f) / radius();
  }
  /// The plate does not turn (RB1).
  template <class X>
  X turning(const FollowerMotion<X>&) const {
    return number<X>(0);
  }
};

}  // namespace camlaw
