// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/oscillating_roller_cam.h"

namespace camlaw {

/// A disc cam with an oscillating roller follower that turns the other way than
/// OscillatingRollerCam (docs/theory.md, "Direction of rotation"): its surface runs towards the
/// pivot (a leading arm), and in the rise cam and arm turn alike. The cam is that of the motion run
/// backwards; fields and validity are the same.
struct LeadingRollerCam : OscillatingRollerCam {
  /// The roller's centre, with derivatives by the angle run backwards.
  CamCurve pitch_curve(const FollowerMotion& f) const {
    return trailing().pitch_curve(backwards(f));
  }
  std::pair<Expression, Expression> placed(const CamPoint& p, const Expression& phi) const {
    return turned_back(p, -phi);
  }
  /// (M32) Pressure angle, rad: tan alpha = (l (psi' - 1) + d cos psi) / (d sin psi).
  Expression pressure_angle(const FollowerMotion& f) const {
    return -trailing().pressure_angle(backwards(f));
  }
  /// (M15) Force between roller and cam, N.
  Expression contact_force(const FollowerMotion& f) const {
    return trailing().contact_force(backwards(f));
  }
  /// What the cam turns under the arm by its own turn, 1 - psi' (RB1).
  Expression turning(const FollowerMotion& f) const { return trailing().turning(backwards(f)); }

 private:
  const OscillatingRollerCam& trailing() const { return *this; }
  static FollowerMotion backwards(const FollowerMotion& f) { return {f.s, -f.ds, f.dds, -f.ddds}; }
};

}  // namespace camlaw
