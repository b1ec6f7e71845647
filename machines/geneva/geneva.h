// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// What a Geneva's driver, turning at unit speed, gives its wheel: angle, velocity ratio and two
/// more derivatives by the driver's angle, all in radians.
struct GenevaMotion {
  Expression angle, ratio, second, third;
};

/// A planar (external) Geneva of n slots, entered without shock (docs/theory.md, "Geneva
/// mechanisms"): the pin's radius is sin(pi / n) of the centre distance. alpha is the driver's
/// angle from the line of centres; the pin is in the slot for |alpha| <= pi / 2 - pi / n.
struct PlanarGeneva {
  Expression slots = 4;  ///< n, 3 or more

  auto conditions() const {
    return std::to_array<Condition>({{slots - 3, "slots must be 3 or more", true}});
  }
  Expression crank() const { return sin(pi() / slots); }
  /// Half the driver's angle in which the wheel moves, rad.
  Expression half_engagement() const { return pi() / 2 - pi() / slots; }

  /// (V1) tan beta = lambda sin alpha / (1 - lambda cos alpha), with q = 1 - 2 lambda cos alpha +
  /// lambda^2: beta' = lambda (cos alpha - lambda) / q, beta'' = -lambda (1 - lambda^2) sin alpha /
  /// q^2, beta''' = -lambda (1 - lambda^2) (cos alpha / q^2 - 4 lambda sin^2 alpha / q^3).
  GenevaMotion at(const Expression& alpha) const {
    const Expression l = crank();
    const Expression c = cos(alpha), s = sin(alpha);
    const Expression q = (1 + l * l) - 2 * l * c;
    const Expression k = l * (1 - l * l);
    return {atan(l * s / (1 - l * c)), l * (c - l) / q, -(k * s / (q * q)),
            -(k * (c - 4 * l * (s * s / q)) / (q * q))};
  }
};

/// A spherical Geneva of n slots, its axes at right angles: the wheel moves while the driver makes
/// half a turn, |alpha| <= pi / 2.
struct SphericalGeneva {
  Expression slots = 4;  ///< n, 3 or more

  auto conditions() const {
    return std::to_array<Condition>({{slots - 3, "slots must be 3 or more", true}});
  }
  Expression half_engagement() const { return pi() / 2; }

  /// (V2) tan beta = tan(pi / n) sin alpha, with k = tan(pi / n), q = 1 + k^2 sin^2 alpha and
  /// w = 1 + k^2 + k^2 cos^2 alpha: beta' = k cos alpha / q, beta'' = -k sin alpha w / q^2,
  /// beta''' = -k cos alpha ((w - 2 k^2 sin^2 alpha) / q^2 - 4 k^2 sin^2 alpha w / q^3).
  GenevaMotion at(const Expression& alpha) const {
    const Expression k = tan(pi() / slots);
    const Expression c = cos(alpha), s = sin(alpha);
    const Expression bent = k * k * (s * s), q = bent + 1, w = k * k * (c * c) + (1 + k * k);
    const Expression third = w - 2 * bent - 4 * (bent * w / q);
    return {atan(k * s), k * c / q, -(k * s * w / (q * q)), -(k * c * third / (q * q))};
  }
};

}  // namespace camlaw
