// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/model/possibility.h"
#include "numerics/scalar/scalar.h"

namespace camlaw {

/// What a Geneva's driver, turning at unit speed, gives its wheel: angle, velocity ratio and two
/// more derivatives by the driver's angle, all in radians.
template <class X>
struct GenevaMotion {
  X angle, ratio, second, third;
};

/// A planar (external) Geneva of n slots, entered without shock (docs/theory.md, "Geneva
/// mechanisms"): the pin's radius is sin(pi / n) of the centre distance. alpha is the driver's
/// angle from the line of centres; the pin is in the slot for |alpha| <= pi / 2 - pi / n.
template <class T>
struct PlanarGeneva {
  T slots = number<T>(4);  ///< n, 3 or more

  auto conditions() const {
    return std::to_array<Condition<T>>({{slots - number<T>(3), "slots must be 3 or more", true}});
  }
  T crank() const {
    using std::sin;
    return sin(pi<T>() / slots);
  }
  /// Half the driver's angle in which the wheel moves, rad.
  T half_engagement() const { return pi<T>() / number<T>(2) - pi<T>() / slots; }

  /// (V1) tan beta = lambda sin alpha / (1 - lambda cos alpha), with q = 1 - 2 lambda cos alpha +
  /// lambda^2: beta' = lambda (cos alpha - lambda) / q, beta'' = -lambda (1 - lambda^2) sin alpha /
  /// q^2, beta''' = -lambda (1 - lambda^2) (cos alpha / q^2 - 4 lambda sin^2 alpha / q^3).
  template <class X>
  GenevaMotion<X> at(const X& alpha) const {
    using std::atan;
    using std::cos;
    using std::sin;
    const T l = crank(), one = number<T>(1);
    const X c = cos(alpha), s = sin(alpha);
    const X q = (one + l * l) - number<T>(2) * l * c;
    const T k = l * (one - l * l);
    return {atan(l * s / (one - l * c)), l * (c - l) / q, -(k * s / (q * q)),
            -(k * (c - number<T>(4) * l * (s * s / q)) / (q * q))};
  }
};

/// A spherical Geneva of n slots, its axes at right angles: the wheel moves while the driver makes
/// half a turn, |alpha| <= pi / 2.
template <class T>
struct SphericalGeneva {
  T slots = number<T>(4);  ///< n, 3 or more

  auto conditions() const {
    return std::to_array<Condition<T>>({{slots - number<T>(3), "slots must be 3 or more", true}});
  }
  T half_engagement() const { return pi<T>() / number<T>(2); }

  /// (V2) tan beta = tan(pi / n) sin alpha, with k = tan(pi / n), q = 1 + k^2 sin^2 alpha and
  /// w = 1 + k^2 + k^2 cos^2 alpha: beta' = k cos alpha / q, beta'' = -k sin alpha w / q^2,
  /// beta''' = -k cos alpha ((w - 2 k^2 sin^2 alpha) / q^2 - 4 k^2 sin^2 alpha w / q^3).
  template <class X>
  GenevaMotion<X> at(const X& alpha) const {
    using std::atan;
    using std::cos;
    using std::sin;
    using std::tan;
    const T k = tan(pi<T>() / slots), one = number<T>(1);
    const X c = cos(alpha), s = sin(alpha);
    const X bent = k * k * (s * s), q = bent + one, w = k * k * (c * c) + (one + k * k);
    const X third = w - number<T>(2) * bent - number<T>(4) * (bent * w / q);
    return {atan(k * s), k * c / q, -(k * s * w / (q * q)), -(k * c * third / (q * q))};
  }
};

}  // namespace camlaw
