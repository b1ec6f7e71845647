// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"

namespace camlaw {

/// A roller at the end of an arm beside a disc cam, or one of a turret's (docs/theory.md, "Roller
/// on an arm"). The arm of length l turns about a pivot at the distance d from the cam's centre, on
/// the x axis; psi is its angle to the line of centres. Fields in m. Of a motion f the derivatives
/// are read.
struct RollerArm {
  Expression length;    ///< l
  Expression distance;  ///< d

  /// The roller's centre: with E = l exp(-i psi), w = d - E, w1 = -i d + i (1 + psi') E,
  /// w2 = -d + ((1 + psi')^2 + i psi'') E.
  CamCurve pitch_curve(const Expression& psi, const FollowerMotion& f) const {
    const auto [c, s] = along(psi);
    const Expression rate = f.ds + 1, square = rate * rate;
    const Expression none = 0;
    return {
        none - c + distance,   s, rate * s, rate * c - distance, square * c + f.dds * s - distance,
        f.dds * c - square * s};
  }
  /// (M14) tan alpha = (l (1 + psi') - d cos psi) / (d sin psi), alpha between the normal and the
  /// path of the roller's centre.
  Expression pressure_angle(const Expression& psi, const FollowerMotion& f) const {
    const auto [c, s] = along(psi);
    const Expression slope = length * (f.ds + 1) - distance * (c / length);
    return atan(slope / (distance * (s / length)));
  }
  /// 1 / cos alpha with the sign of sin psi, |w1| / (d sin psi): above 0 where a force on the
  /// roller, away from the cam, turns the arm to greater angles.
  Expression inclination(const Expression& psi, const FollowerMotion& f) const {
    return pitch_curve(psi, f).speed() / (distance * sin(psi));
  }

 private:
  /// l cos psi, l sin psi.
  std::pair<Expression, Expression> along(const Expression& psi) const {
    return {length * cos(psi), length * sin(psi)};
  }
};

}  // namespace camlaw
