// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/model/given.h"
#include "machines/model/possibility.h"
#include "numerics/scalar/scalar.h"

namespace camlaw {

/// The spine-notching cutter of a perfect binder: a cylindrical cutter rolls on the spine of a book
/// block and sinks into it, while a fixed face cam strokes it axially and back once a revolution
/// (two stretches of half a revolution, no dwell; a spring closes the pair).
///
/// Fields in SI units; T is a scalar, most often Expression. Equations (n) are those of
/// docs/theory.md, "Spine cutter"; source: Tekhnolohiia i tekhnika drukarstva, 2020, No. 4(70).
/// Valid for 0 < depth < cutter_diameter / 2.
template <class T>
struct SpineCutter {
  Given<T> given = {};
  T cutter_diameter =
      given({"cutter_diameter", "D_f", "mm", "m", "outer diameter of the cutter", 50, 1e-3, 1e4});
  T blades = given({"blades", "z", "1", "1", "number of blades", 17, 1, 1e4, true});
  T stroke = given({"stroke", "S_f", "mm", "m", "axial stroke, one way", 40, 1e-3, 1e4});
  T block_speed =
      given({"block_speed", "V", "m/s", "m/s", "speed of the book block", 0.3, 1e-6, 1e3});
  T depth = given({"depth", "h", "mm", "m", "depth of the notches", 0.4, 1e-6, 1e4});
  T mass = given({"mass", "m", "kg", "kg", "mass that the cam moves", 2.4, 1e-6, 1e6});
  T pressure_angle =
      given({"pressure_angle", "v", "deg", "rad", "permissible pressure angle", 30, 0.1, 89.9});
  T cam_radius = given({"cam_radius", "R", "mm", "m", "radius of the cam", 35, 1e-3, 1e4});

  /// Whether the cutter reaches into the block, and less than half of it does.
  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{depth, "depth must be above 0"},
         {cutter_diameter / number<T>(2) - depth, "depth must be below cutter_diameter / 2"}});
  }

  /// (1) Chord of contact, m: S = 2 sqrt((D_f/2)^2 - (D_f/2 - h)^2), as 2 sqrt(h (D_f - h)).
  T chord_of_contact() const {
    using std::sqrt;
    return number<T>(2) * sqrt(depth * (cutter_diameter - depth));
  }
  /// (2) Contact angle, rad: psi = 2 arcsin(S / D_f).
  T contact_angle() const {
    using std::asin;
    return number<T>(2) * asin(chord_of_contact() / cutter_diameter);
  }
  /// (3) Blades in contact at a time: z psi / (2 pi).
  T blades_in_contact() const { return blades * contact_angle() / (number<T>(2) * pi<T>()); }
  /// (4) Path of the block in one revolution of the cutter, m: S_rev = pi (D_f - 2 h).
  T path_per_revolution() const { return pi<T>() * (cutter_diameter - number<T>(2) * depth); }
  /// (5) Angular velocity of cutter and cam roller, rad/s: omega = V / (D_f / 2 - h).
  T angular_velocity() const { return block_speed / (cutter_diameter / number<T>(2) - depth); }
  /// (6) Least cam radius at the permissible pressure angle, m: R = S_f B / (pi tan v) for the peak
  /// velocity constant B of the law: the stroke covers half the cam's circumference.
  T minimum_cam_radius(const T& B) const {
    using std::tan;
    return stroke * B / (pi<T>() * tan(pressure_angle));
  }
  /// Peak inertia force, N, for the peak acceleration constant C of the law. A stretch lasts half a
  /// revolution, S_rev / (2 V), so F = m C S_f (2 V / S_rev)^2.
  T peak_inertia_force(const T& C) const { return number<T>(2) * printed_inertia_force(C); }
  /// (7) The same as the paper prints it, with 2 where half a revolution gives 4:
  /// F = m C 2 S_f V^2 / S_rev^2.
  T printed_inertia_force(const T& C) const {
    const T frequency = block_speed / path_per_revolution();
    return mass * C * number<T>(2) * stroke * frequency * frequency;
  }
  /// Peak torque of the inertia force on the cam's axis, N m, for Cm = max |s' s''| of the law:
  /// force times the reduced velocity, M = m S_f^2 omega^2 Cm / pi^3.
  T peak_drive_torque(const T& Cm) const {
    const T omega = angular_velocity();
    return mass * stroke * stroke * omega * omega * Cm / (pi<T>() * pi<T>() * pi<T>());
  }

  // Over the cam angle the same follow from s', s'' of the law as multiples of these.

  /// (S5) Tangent of the pressure angle for s' = 1: S_f / (pi R) at the cam's radius R.
  T pressure_scale() const { return stroke / (pi<T>() * cam_radius); }
  /// (S6) Cam radius, m, at which the pressure angle is the permissible one for s' = 1.
  T radius_scale() const { return minimum_cam_radius(number<T>(1)); }
  /// (S1) Inertia force, N, for s'' = 1.
  T force_scale() const { return peak_inertia_force(number<T>(1)); }
  /// (S2) Drive torque, N m, for s' s'' = 1.
  T torque_scale() const { return peak_drive_torque(number<T>(1)); }
};

}  // namespace camlaw
