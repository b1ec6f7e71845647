// SPDX-License-Identifier: MIT
#pragma once

#include "machines/contact/hertz.h"

namespace camlaw {

/// What a roller does to the profile that it runs on, from the pitch curve's curvature k, 1/m,
/// positive where the cam is convex, and the force N between them, N (docs/theory.md, "Roller on a
/// disc cam"). Fields in SI units.
template <class T>
struct RollerContact {
  T roller_radius;  ///< r_r, m
  T cutter_radius;  ///< r_c, m, of the tool that cuts the profile
  T face_width;     ///< b, m
  LineContact<T> material;

  /// (M7) Share of the pitch curve's radius that the roller takes, r_r k: the profile is undercut
  /// where it reaches 1.
  template <class X>
  X undercut(const X& k) const {
    return roller_radius * k;
  }
  /// (M8) Curvature of the profile, 1/m: k_c = k / (1 - r_r k); of a hollow part negative.
  template <class X>
  X profile_curvature(const X& k) const {
    return k / (number<T>(1) - roller_radius * k);
  }
  /// Share of a hollow's radius that the tool takes, -r_c k_c: above 1 the tool does not fit.
  template <class X>
  X tool_fit(const X& k) const {
    return -(cutter_radius * profile_curvature(k));
  }
  /// Share of a groove's half width, the roller's radius, that the tool takes, r_c / r_r. A tool
  /// that goes in cuts both flanks where neither is undercut by the roller: its path is as far from
  /// the pitch curve as the roller's radius is larger.
  T groove_fit() const { return cutter_radius / roller_radius; }
  /// (M10) Sum of the curvatures of profile and roller, k_c + 1 / r_r = 1 / (r_r (1 - r_r k)).
  template <class X>
  X curvature_sum(const X& k) const {
    return number<X>(1) / (roller_radius * (number<T>(1) - roller_radius * k));
  }
  /// (K2) Greatest pressure, Pa.
  template <class X>
  X stress(const X& force, const X& k) const {
    return material.pressure(force / face_width, curvature_sum(k));
  }
  /// (K3) Half the contact's width, m.
  template <class X>
  X half_width(const X& force, const X& k) const {
    return material.half_width(force / face_width, curvature_sum(k));
  }
};

}  // namespace camlaw
