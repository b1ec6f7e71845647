// SPDX-License-Identifier: MIT
#pragma once

#include "machines/contact/hertz.h"

namespace camlaw {

/// What a roller does to the profile that it runs on, from the pitch curve's curvature k, 1/m,
/// positive where the cam is convex, and the force N between them, N (docs/theory.md, "Roller on a
/// disc cam"). Fields in SI units.
struct RollerContact {
  Expression roller_radius;  ///< r_r, m
  Expression cutter_radius;  ///< r_c, m, of the tool that cuts the profile
  Expression face_width;     ///< b, m
  LineContact material;

  /// (M7) Share of the pitch curve's radius that the roller takes, r_r k: the profile is undercut
  /// where it reaches 1.
  Expression undercut(const Expression& k) const { return roller_radius * k; }
  /// (M8) Curvature of the profile, 1/m: k_c = k / (1 - r_r k); of a hollow part negative.
  Expression profile_curvature(const Expression& k) const { return k / (1 - roller_radius * k); }
  /// Share of a hollow's radius that the tool takes, -r_c k_c: above 1 the tool does not fit.
  Expression tool_fit(const Expression& k) const { return -(cutter_radius * profile_curvature(k)); }
  /// Share of a groove's half width, the roller's radius, that the tool takes, r_c / r_r. A tool
  /// that goes in cuts both flanks where neither is undercut by the roller: its path is as far from
  /// the pitch curve as the roller's radius is larger.
  Expression groove_fit() const { return cutter_radius / roller_radius; }
  /// (M10) Sum of the curvatures of profile and roller, k_c + 1 / r_r = 1 / (r_r (1 - r_r k)).
  Expression curvature_sum(const Expression& k) const {
    return 1 / (roller_radius * (1 - roller_radius * k));
  }
  /// (K2) Greatest pressure, Pa.
  Expression stress(const Expression& force, const Expression& k) const {
    return material.pressure(force / face_width, curvature_sum(k));
  }
  /// (K3) Half the contact's width, m.
  Expression half_width(const Expression& force, const Expression& k) const {
    return material.half_width(force / face_width, curvature_sum(k));
  }
};

}  // namespace camlaw
