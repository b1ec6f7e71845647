// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "kinematics/scalar.h"

namespace camlaw {

/// What a Geneva's driver, turning at unit speed, gives its wheel: angle, velocity ratio and the
/// second derivative by the driver's angle, all in radians.
template <class X>
struct GenevaMotion {
  X angle, ratio, second;
};

/// A planar (external) Geneva of n slots, entered without shock (docs/theory.md, "Geneva
/// mechanisms"): the pin's radius is sin(pi / n) of the centre distance. alpha is the driver's
/// angle from the line of centres; the pin is in the slot for |alpha| <= pi / 2 - pi / n.
template <class T>
struct PlanarGeneva {
  T slots = number<T>(4);  ///< n, 3 or more

  T crank() const {
    using std::sin;
    return sin(pi<T>() / slots);
  }
  /// Half the driver's angle in which the wheel moves, rad.
  T half_engagement() const { return pi<T>() / number<T>(2) - pi<T>() / slots; }

  /// (V1) tan beta = lambda sin alpha / (1 - lambda cos alpha), with
  /// beta' = lambda (cos alpha - lambda) / (1 - 2 lambda cos alpha + lambda^2) and
  /// beta'' = -lambda (1 - lambda^2) sin alpha / (1 - 2 lambda cos alpha + lambda^2)^2.
  template <class X>
  GenevaMotion<X> at(const X& alpha) const {
    using std::atan;
    using std::cos;
    using std::sin;
    const T l = crank(), one = number<T>(1);
    const X c = cos(alpha), s = sin(alpha);
    const X square = (one + l * l) - number<T>(2) * l * c;
    return {atan(l * s / (one - l * c)), l * (c - l) / square,
            -(l * (one - l * l) * s / (square * square))};
  }
};

/// A spherical Geneva of n slots, its axes at right angles: the wheel moves while the driver makes
/// half a turn, |alpha| <= pi / 2.
template <class T>
struct SphericalGeneva {
  T slots = number<T>(4);

  T half_engagement() const { return pi<T>() / number<T>(2); }

  /// (V2) tan beta = tan(pi / n) sin alpha, with beta' = k cos alpha / q, beta'' = -k sin alpha
  /// (1 + k^2 + k^2 cos^2 alpha) / q^2, k = tan(pi / n), q = 1 + k^2 sin^2 alpha.
  template <class X>
  GenevaMotion<X> at(const X& alpha) const {
    using std::atan;
    using std::cos;
    using std::sin;
    using std::tan;
    const T k = tan(pi<T>() / slots), one = number<T>(1);
    const X c = cos(alpha), s = sin(alpha);
    const X q = k * k * (s * s) + one;
    return {atan(k * s), k * c / q, -(k * s * (k * k * (c * c) + (one + k * k)) / (q * q))};
  }
};

}  // namespace camlaw
