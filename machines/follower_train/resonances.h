// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "kinematics/law.h"

/// How much the steady state of an elastic train may bend as the speed changes (docs/theory.md,
/// "Elastic end of a follower").
namespace camlaw {

/// (U11), (U12) Bounds of y'', the end's acceleration in the steady state, and of its second
/// derivative by the logarithm of the speed, over max |s''|.
template <class T>
T most_response(const T& zeta) {
  using std::sqrt;
  const T one = number<T>(1);
  return one / (zeta * sqrt(one - zeta * zeta));
}
template <class T>
T most_bend(const T& zeta) {
  using std::sqrt;
  const T one = number<T>(1);
  return (one + number<T>(3) / zeta + number<T>(2) / (zeta * zeta)) /
         (zeta * sqrt(one - zeta * zeta));
}

/// What is known of the acceleration s'' of a periodic motion, by the turn.
template <class T>
struct BoundedAcceleration {
  T most;       ///< max |s''|
  T variation;  ///< total variation over a turn, jumps included; may be infinite
};

/// A bound of the total variation of s'' over a turn of a motion that repeats; infinite where s'''
/// is not bounded.
double acceleration_variation(const Law<Interval>& law);

/// (U13) A bound of the second derivative of y'' by the logarithm of the speed, at all speeds of so
/// many turns in a natural period: from `slow` to `fast`. T is double or Interval.
template <class T>
T resonant_bend(const BoundedAcceleration<T>& acceleration, const T& damping_ratio, const T& slow,
                const T& fast);

}  // namespace camlaw
