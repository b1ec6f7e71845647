// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/elastic_end.h"
#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

/// What all index drives have in common: a turret whose rollers a cam moves on, one after the
/// other, by a motion that does not return (docs/theory.md, "Index drives").
namespace camlaw {

/// What the turret asks for. Fields in SI units.
struct IndexLoad {
  Expression inertia;        ///< J, kg m^2, of turret, table and load
  Expression friction;       ///< M_C, N m
  Expression load;           ///< M_L, N m, constant, against the motion
  Expression angular_speed;  ///< omega, rad/s, of the cam

  /// (IX2) J omega^2 psi''.
  Expression inertia_torque(const FollowerMotion& f) const {
    return inertia * angular_speed * angular_speed * f.dds;
  }
  /// (IX2) Torque that the turret asks for, N m: M = J omega^2 psi'' + M_C sgn psi' + M_L. Below 0
  /// it must be held back.
  Expression torque(const FollowerMotion& f) const {
    return inertia_torque(f) + along(f.ds, friction) + load;
  }
  /// (IX3) Torque on the cam's shaft without losses, N m: M psi'.
  Expression drive_torque(const FollowerMotion& f) const { return torque(f) * f.ds; }
};

/// (IX19) Friction is not among them.
inline TrainLoads train_loads(const IndexLoad& load) { return {load.inertia, load.load, 0}; }

/// (IX1) What a turret turns by where its motion has the displacement 1, rad: 2 pi / S.
inline Expression station_angle(const Expression& stations) { return 2 * pi() / stations; }

/// At most so many rollers of a turret are handed over in a cycle.
inline constexpr int kMostHandovers = 8;

/// How many of the places (j - before) step, j = 1, 2, ..., y has reached.
inline Expression steps_passed(const Expression& y, const Expression& step, double before) {
  Expression count = 0;
  for (int j = 1; j <= kMostHandovers + 1; ++j) {
    count = count + by_side(y / step - Expression(j - before), 1, 0);
  }
  return count;
}

/// A dwell at a hand-over is the taking roller's, in spite of rounding: this part of a step. A
/// motion that ends there is farther from it (problems::kRestRounding), with the leaving roller.
inline constexpr double kHandoverRounding = 1e-12;

/// (IX5) y - step floor(y / step): what the turret's angle y has gained, rad, since the roller took
/// over that serves now, for y from 0 to kMostHandovers + 1 steps.
inline Expression since_handover(const Expression& y, const Expression& step) {
  return y - step * steps_passed(y, step, kHandoverRounding);
}

/// of_gain(since_handover(y, step)), written so that enclosures about a hand-over are those of the
/// two rollers and not of all angles between them: near it the count of the nearest hand-over is
/// constant, between two of them the count of those passed is. There the formulas agree.
template <class F>
Expression handed_over(const Expression& y, const Expression& step, F of_gain) {
  const Expression between = of_gain(y - step * steps_passed(y, step, 0));
  const Expression past = y - step * steps_passed(y, step, 0.5);  // from half a step before it
  const Expression leaving = of_gain(past + step), taking = of_gain(past);
  const Expression near = by_side(past + Expression(kHandoverRounding) * step, taking, leaving);
  return by_side(-cos(2 * pi() / step * y), between, near);
}

}  // namespace camlaw
