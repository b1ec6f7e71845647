// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"

namespace camlaw {

/// A roller at the end of an arm beside a disc cam, or one of a turret's (docs/theory.md, "Roller
/// on an arm"). The arm of length l turns about a pivot at the distance d from the cam's centre, on
/// the x axis; psi is its angle to the line of centres. Fields in m. Of a motion f the derivatives
/// are read.
template <class T>
struct RollerArm {
  T length;    ///< l
  T distance;  ///< d

  /// The roller's centre: with E = l exp(-i psi), w = d - E, w1 = -i d + i (1 + psi') E,
  /// w2 = -d + ((1 + psi')^2 + i psi'') E.
  template <class X>
  CamCurve<X> pitch_curve(const X& psi, const FollowerMotion<X>& f) const {
    const auto [c, s] = along(psi);
    const X rate = f.ds + number<T>(1), square = rate * rate;
    const X none = number<X>(0);
    return {
        none - c + distance,   s, rate * s, rate * c - distance, square * c + f.dds * s - distance,
        f.dds * c - square * s};
  }
  /// (M14) tan alpha = (l (1 + psi') - d cos psi) / (d sin psi), alpha between the normal and the
  /// path of the roller's centre.
  template <class X>
  X pressure_angle(const X& psi, const FollowerMotion<X>& f) const {
    using std::atan;
    const auto [c, s] = along(psi);
    const X slope = length * (f.ds + number<T>(1)) - distance * (c / length);
    return atan(slope / (distance * (s / length)));
  }
  /// 1 / cos alpha with the sign of sin psi, |w1| / (d sin psi): above 0 where a force on the
  /// roller, away from the cam, turns the arm to greater angles.
  template <class X>
  X inclination(const X& psi, const FollowerMotion<X>& f) const {
    using std::sin;
    return pitch_curve(psi, f).speed() / (distance * sin(psi));
  }

 private:
  /// l cos psi, l sin psi.
  template <class X>
  std::pair<X, X> along(const X& psi) const {
    using std::cos;
    using std::sin;
    return {length * cos(psi), length * sin(psi)};
  }
};

}  // namespace camlaw
