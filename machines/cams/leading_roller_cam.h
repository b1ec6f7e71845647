// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/oscillating_roller_cam.h"

namespace camlaw {

/// A disc cam with an oscillating roller follower that turns the other way than
/// OscillatingRollerCam (docs/theory.md, "Either rotation"): its surface runs towards the pivot (a
/// leading arm), and in the rise cam and arm turn alike. The cam is that of the motion run
/// backwards; fields and validity are the same.
template <class T>
struct LeadingRollerCam : OscillatingRollerCam<T> {
  /// The roller's centre, with derivatives by the angle run backwards.
  template <class X>
  CamCurve<X> pitch_curve(const FollowerMotion<X>& f) const {
    return trailing().pitch_curve(backwards(f));
  }
  template <class X>
  std::pair<X, X> placed(const CamPoint<X>& p, const X& phi) const {
    return turned_back(p, X(-phi));
  }
  /// (M32) Pressure angle, rad: tan alpha = (l (psi' - 1) + d cos psi) / (d sin psi).
  template <class X>
  X pressure_angle(const FollowerMotion<X>& f) const {
    return -trailing().pressure_angle(backwards(f));
  }
  /// (M15) Force between roller and cam, N.
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    return trailing().contact_force(backwards(f));
  }
  /// What the cam turns under the arm by its own turn, 1 - psi' (RB1).
  template <class X>
  X turning(const FollowerMotion<X>& f) const {
    return trailing().turning(backwards(f));
  }

 private:
  const OscillatingRollerCam<T>& trailing() const { return *this; }
  template <class X>
  static FollowerMotion<X> backwards(const FollowerMotion<X>& f) {
    return {f.s, -f.ds, f.dds, -f.ddds};
  }
};

}  // namespace camlaw
