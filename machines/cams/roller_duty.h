// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/roller_contact.h"
#include "machines/contact/lubricant.h"
#include "numerics/scalar/absolute.h"
#include "numerics/scalar/by_side.h"
#include "numerics/scalar/power.h"

namespace camlaw {

/// What a roller bears as a bearing on its pin, and what lubricates it on its cam (docs/theory.md,
/// "Rollers as bearings"). Fields in SI units.
template <class T>
struct RollerDuty {
  T crown_radius;        ///< R_c, m, of the roller's face along its axis
  T dynamic_rating;      ///< C, N
  T static_rating;       ///< C_0, N
  T speed_limit;         ///< n_G, rad/s, of the roller on its pin
  T viscosity;           ///< eta, Pa s
  T pressure_viscosity;  ///< alpha, 1/Pa
  T roughness;           ///< R_q, m, of both surfaces

  /// The crown may have a symbol of its own.
  static RollerDuty given_by(Given<T>& given, const MachineParameter& crown = cams::kCrownRadius) {
    using namespace cams;
    return {given(crown),      given(kDynamicRating),     given(kStaticRating), given(kSpeedLimit),
            given(kViscosity), given(kPressureViscosity), given(kRoughness)};
  }

  /// Of the roller's face along its axis, 1/m.
  T crown_curvature() const { return number<T>(1) / crown_radius; }
  Lubricant<T> lubricant() const { return {viscosity, pressure_viscosity, roughness}; }

  /// (RB3) Life, revolutions of the roller, from the equivalent load P, N: 10^6 (C / P)^p.
  T revolutions(const T& equivalent_load) const {
    return number<T>(kMillion) * power(T(dynamic_rating / equivalent_load), kExponent);
  }
  /// (RB4) Life, s, from the mean of |N|^p nu over the turn and the cam's speed, rad/s:
  /// 10^6 C^p 2 pi / (omega mean).
  T life(const T& mean, const T& angular_speed) const {
    return number<T>(kMillion) * power(dynamic_rating, kExponent) * number<T>(2) * pi<T>() /
           (angular_speed * mean);
  }
  /// (RB2) Equivalent load, N, from the means of |N|^p nu and of nu. It is a norm of the load:
  /// where nothing bears it is 0, with slopes 0.
  static T equivalent_load(const T& mean, const T& turns) {
    return unless_zero(mean, T(power(T(mean / turns), 1 / kExponent)));
  }
  /// |N|^p, p = 10/3 of roller bearings.
  template <class X>
  static X to_life_exponent(const X& force) {
    return power(absolute(force), kExponent);
  }

  /// The exponent of roller bearings in ISO 281, whose rating is for a million revolutions.
  static constexpr double kExponent = 10.0 / 3, kMillion = 1e6;
};

/// (RB1) Turns of a roller on its pin, by those of the cam: nu = | |w1| / r_r - chi | on a cam's
/// own flank, | |w1| / r_r + chi | on the outer one of a groove, which it runs on where the force
/// is below 0. chi says how fast the cam turns under what carries the roller.
template <class T, class X>
X roller_turns(const X& force, const X& pitch_speed, const X& turning, const T& roller_radius) {
  const X rolled = number<T>(1) / roller_radius * pitch_speed;
  return absolute(by_side(force, X(rolled - turning), X(rolled + turning)));
}

/// (RB7) How far the contact runs along the profile, and along the roller alike, as they roll on
/// one another, m by radian of the cam: |w1| (1 - r_r k).
template <class T, class X>
X rolled_way(const CamCurve<X>& pitch, const T& roller_radius) {
  return pitch.speed() * (number<X>(1) - roller_radius * pitch.curvature());
}

}  // namespace camlaw
