// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/roller_contact.h"
#include "machines/contact/lubricant.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// What a roller bears as a bearing on its pin, and what lubricates it on its cam (docs/theory.md,
/// "Speed and life of rollers"). Fields in SI units.
struct RollerDuty {
  Expression crown_radius;        ///< R_c, m, of the roller's face along its axis
  Expression dynamic_rating;      ///< C, N
  Expression static_rating;       ///< C_0, N
  Expression speed_limit;         ///< n_G, rad/s, of the roller on its pin
  Expression viscosity;           ///< eta, Pa s
  Expression pressure_viscosity;  ///< alpha, 1/Pa
  Expression roughness;           ///< R_q, m, of both surfaces

  /// The crown may have a symbol of its own.
  static RollerDuty given_by(Given& given, const MachineParameter& crown = cams::kCrownRadius) {
    using namespace cams;
    return {given(crown),      given(kDynamicRating),     given(kStaticRating), given(kSpeedLimit),
            given(kViscosity), given(kPressureViscosity), given(kRoughness)};
  }

  /// Of the roller's face along its axis, 1/m.
  Expression crown_curvature() const { return 1 / crown_radius; }
  Lubricant lubricant() const { return {viscosity, pressure_viscosity, roughness}; }

  /// (RB3) Life, revolutions of the roller, from the equivalent load P, N: 10^6 (C / P)^p.
  Expression revolutions(const Expression& equivalent_load) const {
    return kMillion * power(dynamic_rating / equivalent_load, kExponent);
  }
  /// (RB4) Life, s, from the mean of |N|^p nu over the turn and the cam's speed, rad/s:
  /// 10^6 C^p 2 pi / (omega mean).
  Expression life(const Expression& mean, const Expression& angular_speed) const {
    return kMillion * power(dynamic_rating, kExponent) * 2 * pi() / (angular_speed * mean);
  }
  /// (RB2) Equivalent load, N, from the means of |N|^p nu and of nu. It is a norm of the load:
  /// where nothing bears it is 0, with slopes 0.
  static Expression equivalent_load(const Expression& mean, const Expression& turns) {
    return unless_zero(mean, power(mean / turns, 1 / kExponent));
  }
  /// |N|^p, p = 10/3 of roller bearings.
  static Expression to_life_exponent(const Expression& force) {
    return power(absolute(force), kExponent);
  }

  /// The exponent of roller bearings in ISO 281, whose rating is for a million revolutions.
  static constexpr double kExponent = 10.0 / 3;
  static constexpr int kMillion = 1'000'000;
};

/// (RB1) Turns of a roller on its pin, by those of the cam: nu = | |w1| / r_r - chi | on a cam's
/// own flank, | |w1| / r_r + chi | on the outer one of a groove, which it runs on where the force
/// is below 0. chi says how fast the cam turns under what carries the roller.
inline Expression roller_turns(const Expression& force, const Expression& pitch_speed,
                               const Expression& turning, const Expression& roller_radius) {
  const Expression rolled = 1 / roller_radius * pitch_speed;
  return absolute(by_side(force, rolled - turning, rolled + turning));
}

/// (RB7) How far the contact runs along the profile, and along the roller alike, as they roll on
/// one another, m by radian of the cam: |w1| (1 - r_r k).
inline Expression rolled_way(const CamCurve& pitch, const Expression& roller_radius) {
  return pitch.speed() * (1 - roller_radius * pitch.curvature());
}

}  // namespace camlaw
