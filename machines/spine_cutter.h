// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/model/given.h"
#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// The spine-notching cutter of a perfect binder: a cylindrical cutter rolls on the spine of a book
/// block and sinks into it, while a fixed face cam strokes it axially and back once a revolution
/// (two stretches of half a revolution, no dwell; a spring closes the pair).
///
/// Fields in SI units. Equations (n) are those of docs/theory.md, "Spine cutter"; source:
/// Tekhnolohiia i tekhnika drukarstva, 2020, No. 4(70). Valid for 0 < depth < cutter_diameter / 2.
struct SpineCutter {
  Given given = {};
  Expression cutter_diameter =
      given({"cutter_diameter", "D_f", "mm", "m", "outer diameter of the cutter", 50, 1e-3, 1e4});
  Expression blades = given({"blades", "z", "1", "1", "number of blades", 17, 1, 1e4, true});
  Expression stroke = given({"stroke", "S_f", "mm", "m", "axial stroke, one way", 40, 1e-3, 1e4});
  Expression block_speed =
      given({"block_speed", "V", "m/s", "m/s", "speed of the book block", 0.3, 1e-6, 1e3});
  Expression depth = given({"depth", "h", "mm", "m", "depth of the notches", 0.4, 1e-6, 1e4});
  Expression mass = given({"mass", "m", "kg", "kg", "mass that the cam moves", 2.4, 1e-6, 1e6});
  Expression pressure_angle =
      given({"pressure_angle", "v", "deg", "rad", "permissible pressure angle", 30, 0.1, 89.9});
  Expression cam_radius = given({"cam_radius", "R", "mm", "m", "radius of the cam", 35, 1e-3, 1e4});

  /// Whether the cutter reaches into the block, and less than half of it does.
  auto conditions() const {
    return std::to_array<Condition>(
        {{depth, "depth must be above 0"},
         {cutter_diameter / 2 - depth, "depth must be below cutter_diameter / 2"}});
  }

  /// (1) Chord of contact, m: S = 2 sqrt((D_f/2)^2 - (D_f/2 - h)^2), as 2 sqrt(h (D_f - h)).
  Expression chord_of_contact() const { return 2 * sqrt(depth * (cutter_diameter - depth)); }
  /// (2) Contact angle, rad: psi = 2 arcsin(S / D_f).
  Expression contact_angle() const { return 2 * asin(chord_of_contact() / cutter_diameter); }
  /// (3) Blades in contact at a time: z psi / (2 pi).
  Expression blades_in_contact() const { return blades * contact_angle() / (2 * pi()); }
  /// (4) Path of the block in one revolution of the cutter, m: S_rev = pi (D_f - 2 h).
  Expression path_per_revolution() const { return pi() * (cutter_diameter - 2 * depth); }
  /// (5) Angular velocity of cutter and cam roller, rad/s: omega = V / (D_f / 2 - h).
  Expression angular_velocity() const { return block_speed / (cutter_diameter / 2 - depth); }
  /// (6) Least cam radius at the permissible pressure angle, m: R = S_f B / (pi tan v) for the peak
  /// velocity constant B of the law: the stroke covers half the cam's circumference.
  Expression minimum_cam_radius(const Expression& B) const {
    return stroke * B / (pi() * tan(pressure_angle));
  }
  /// Peak inertia force, N, for the peak acceleration constant C of the law. A stretch lasts half a
  /// revolution, S_rev / (2 V), so F = m C S_f (2 V / S_rev)^2.
  Expression peak_inertia_force(const Expression& C) const { return 2 * printed_inertia_force(C); }
  /// (7) The same as the paper prints it, with 2 where half a revolution gives 4:
  /// F = m C 2 S_f V^2 / S_rev^2.
  Expression printed_inertia_force(const Expression& C) const {
    const Expression frequency = block_speed / path_per_revolution();
    return mass * C * 2 * stroke * frequency * frequency;
  }
  /// Peak torque of the inertia force on the cam's axis, N m, for Cm = max |s' s''| of the law:
  /// force times the reduced velocity, M = m S_f^2 omega^2 Cm / pi^3.
  Expression peak_drive_torque(const Expression& Cm) const {
    const Expression omega = angular_velocity();
    return mass * stroke * stroke * omega * omega * Cm / (pi() * pi() * pi());
  }

  // Over the cam angle the same follow from s', s'' of the law as multiples of these.

  /// (S5) Tangent of the pressure angle for s' = 1: S_f / (pi R) at the cam's radius R.
  Expression pressure_scale() const { return stroke / (pi() * cam_radius); }
  /// (S6) Cam radius, m, at which the pressure angle is the permissible one for s' = 1.
  Expression radius_scale() const { return minimum_cam_radius(1); }
  /// (S1) Inertia force, N, for s'' = 1.
  Expression force_scale() const { return peak_inertia_force(1); }
  /// (S2) Drive torque, N m, for s' s'' = 1.
  Expression torque_scale() const { return peak_drive_torque(1); }
};

}  // namespace camlaw
