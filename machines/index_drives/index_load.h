// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/elastic_end.h"
#include "machines/model/possibility.h"
#include "numerics/scalar/by_side.h"

/// What all index drives have in common: a turret whose rollers a cam moves on, one after the
/// other, by a motion that does not return (docs/theory.md, "Index drives").
namespace camlaw {

/// What the turret asks for. Fields in SI units.
template <class T>
struct IndexLoad {
  T inertia;        ///< J, kg m^2, of turret, table and load
  T friction;       ///< M_C, N m
  T load;           ///< M_L, N m, constant, against the motion
  T angular_speed;  ///< omega, rad/s, of the cam

  /// (IX2) J omega^2 psi''.
  template <class X>
  X inertia_torque(const FollowerMotion<X>& f) const {
    return inertia * angular_speed * angular_speed * f.dds;
  }
  /// (IX2) Torque that the turret asks for, N m: M = J omega^2 psi'' + M_C sgn psi' + M_L. Below 0
  /// it must be held back.
  template <class X>
  X torque(const FollowerMotion<X>& f) const {
    return inertia_torque(f) + along(f.ds, X(number<X>(0) + friction)) + load;
  }
  /// (IX3) Torque on the cam's shaft without losses, N m: M psi'.
  template <class X>
  X drive_torque(const FollowerMotion<X>& f) const {
    return torque(f) * f.ds;
  }
};

/// (IX19) Friction is not among them.
template <class T>
TrainLoads<T> train_loads(const IndexLoad<T>& load) {
  return {load.inertia, load.load, number<T>(0)};
}

/// (IX1) What a turret turns by where its motion has the displacement 1, rad: 2 pi / S.
template <class T>
T station_angle(const T& stations) {
  return number<T>(2) * pi<T>() / stations;
}

/// At most so many rollers of a turret are handed over in a cycle.
inline constexpr int kMostHandovers = 8;

/// How many of the places (j - before) step, j = 1, 2, ..., y has reached.
template <class T, class X>
X steps_passed(const X& y, const T& step, double before) {
  X count = number<X>(0);
  for (int j = 1; j <= kMostHandovers + 1; ++j) {
    count = count + by_side(X(y / step - number<T>(j - before)), number<X>(1), number<X>(0));
  }
  return count;
}

/// A dwell at a hand-over is the taking roller's, in spite of rounding: this part of a step. A
/// motion that ends there is farther from it (problems::kRestRounding), with the leaving roller.
inline constexpr double kHandoverRounding = 1e-12;

/// (IX5) y - step floor(y / step): what the turret's angle y has gained, rad, since the roller took
/// over that serves now, for y from 0 to kMostHandovers + 1 steps.
template <class T, class X>
X since_handover(const X& y, const T& step) {
  return y - step * steps_passed(y, step, kHandoverRounding);
}

/// of_gain(since_handover(y, step)), written so that enclosures about a hand-over are those of the
/// two rollers and not of all angles between them: near it the count of the nearest hand-over is
/// constant, between two of them the count of those passed is. There the formulas agree.
template <class T, class X, class F>
X handed_over(const X& y, const T& step, F of_gain) {
  using std::cos;
  const X between = of_gain(X(y - step * steps_passed(y, step, 0)));
  const X past = y - step * steps_passed(y, step, 0.5);  // from half a step before it
  const X leaving = of_gain(X(past + step)), taking = of_gain(past);
  const X near = by_side(X(past + number<T>(kHandoverRounding) * step), taking, leaving);
  return by_side(X(-cos(number<T>(2) * pi<T>() / step * y)), between, near);
}

}  // namespace camlaw
