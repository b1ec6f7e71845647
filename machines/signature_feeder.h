// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "kinematics/law.h"
#include "machines/model/given.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// The drive of the delivery cylinder of a reversing signature feeder: a crank moves the end of a
/// rack that slides in a guide rocking about O2, and the rack turns the pinion on the cylinder.
///
/// Fields in SI units; phi is the crank's angle, 0 where its pin is nearest to O2. Equations (Zn)
/// are those of docs/theory.md, "Signature feeder"; source: O. V. Romanchenko, Z. M. Prystavskyi,
/// "Synthesis of the coulisse-rack mechanism and determination of the kinematic characteristics of
/// the delivery cylinders of the reversing signature feeder", NTUU KPI. It prints no speed: 60 rpm
/// is ours.
struct SignatureFeeder {
  Given given = {};
  Expression crank_radius =
      given({"crank_radius", "r1", "mm", "m", "radius of the crank", 92, 1e-3, 1e5});
  Expression centre_distance =
      given({"centre_distance", "L", "mm", "m", "distance of the centres of crank and guide", 702,
             1e-3, 1e5});
  Expression offset =
      given({"offset", "e", "mm", "m", "distance of the guide's centre from the rack's pitch line",
             52, 0, 1e5});
  Expression pinion_radius = given(
      {"pinion_radius", "r_p", "mm", "m", "pitch radius of the cylinder's pinion", 45, 1e-3, 1e5});
  Expression crank_speed =
      given({"speed", "n", "rpm", "rad/s", "speed of the crank", 60, 1e-3, 1e6});

  /// Whether the rack stays in its guide all round, its pitch line also where it meshes with the
  /// pinion: e and r_p less than the crank pin's least distance from O2.
  auto conditions() const {
    const Expression nearest = centre_distance - crank_radius;
    return std::to_array<Condition>(
        {{crank_radius, "crank_radius must be above 0"},
         {pinion_radius, "pinion_radius must be above 0"},
         {nearest - absolute(offset),
          "offset must be less in size than centre_distance - crank_radius"},
         {nearest - pinion_radius, "pinion_radius must be below centre_distance - crank_radius"}});
  }
  /// The same drive with its rack meshing with a pinion on the guide's centre: e = r_p.
  SignatureFeeder meshing() const {
    SignatureFeeder result = *this;
    result.offset = pinion_radius;
    return result;
  }

  /// Quantities at a crank angle with their derivatives by it.
  struct Turn {
    Expression value, first, second;
  };

  /// (Z1) Distance of the crank pin from O2, squared, m^2: r1^2 + L^2 - 2 L r1 cos phi.
  Expression pin_distance_squared(const Expression& phi) const {
    const Expression sum = crank_radius * crank_radius + centre_distance * centre_distance;
    return sum - 2 * reach() * cos(phi);
  }
  /// (Z2) Guide length, m: l^2 = rho^2 - e^2; l' = L r1 sin phi / l, l'' = (L r1 cos phi - l'^2) /
  /// l.
  Turn guide_length(const Expression& phi) const {
    using std::cos, std::sin, std::sqrt;
    const Expression l = sqrt(pin_distance_squared(phi) - offset * offset);
    const Expression first = reach() * sin(phi) / l;
    return {l, first, (reach() * cos(phi) - first * first) / l};
  }
  /// (Z3) Guide angle, rad, from its extreme position: arcsin((r1 - e) / L) - arcsin(r1 sin phi /
  /// rho) + arcsin(e / rho); phi_2' = -(r1 (L cos phi - r1) + e l') / rho^2.
  Turn guide_angle(const Expression& phi) const {
    using std::asin, std::cos, std::sin, std::sqrt;
    const Expression square = pin_distance_squared(phi), rho = sqrt(square);
    const Turn l = guide_length(phi);
    const Expression sine = sin(phi);
    const Expression value = extreme_angle() - asin(crank_radius * sine / rho) + asin(offset / rho);
    const Expression turning = reach() * cos(phi) - crank_radius * crank_radius + offset * l.first;
    const Expression bent = offset * l.second - reach() * sine;
    const Expression first = -turning / square;
    return {value, first, -(bent + 2 * reach() * (sine * first)) / square};
  }
  /// (Z4) Travel of the rack over the pinion, m, 0 at phi = 0: S = l - l_min - e (phi_2(0) -
  /// phi_2).
  Turn rack_travel(const Expression& phi) const {
    const Turn l = guide_length(phi), angle = guide_angle(phi);
    return {l.value - least_guide_length() + offset * (angle.value - start_angle()),
            l.first + offset * angle.first, l.second + offset * angle.second};
  }
  /// (Z5) Angle of pinion and cylinder, rad: phi_4 = S / r_p.
  Turn drum_angle(const Expression& phi) const {
    const Turn travel = rack_travel(phi);
    return {travel.value / pinion_radius, travel.first / pinion_radius,
            travel.second / pinion_radius};
  }
  /// (Z6) Angular velocity of the cylinder, rad/s: omega_1 phi_4'.
  Expression drum_velocity(const Expression& phi) const {
    return crank_speed * drum_angle(phi).first;
  }
  /// (Z7) Angular acceleration of the cylinder, rad/s^2: omega_1^2 phi_4''.
  Expression drum_acceleration(const Expression& phi) const {
    return crank_speed * crank_speed * drum_angle(phi).second;
  }

  /// (Z8) Swing of the cylinder between its two reversals, rad: 2 r1 / r_p, whatever e and L.
  Expression drum_swing() const { return 2 * crank_radius / pinion_radius; }
  /// (Z9) Swing of the guide, rad: arcsin((r1 - e) / L) + arcsin((r1 + e) / L).
  Expression guide_swing() const {
    return extreme_angle() + asin((crank_radius + offset) / centre_distance);
  }
  /// Least and greatest guide length, m: l^2 = (L -+ r1)^2 - e^2.
  Expression least_guide_length() const { return length_at(centre_distance - crank_radius); }
  Expression greatest_guide_length() const { return length_at(centre_distance + crank_radius); }

 private:
  Expression reach() const { return centre_distance * crank_radius; }
  Expression length_at(const Expression& rho) const {
    return sqrt((rho - offset) * (rho + offset));
  }
  Expression extreme_angle() const { return asin((crank_radius - offset) / centre_distance); }
  Expression start_angle() const {
    return extreme_angle() + asin(offset / (centre_distance - crank_radius));
  }
};

}  // namespace camlaw
