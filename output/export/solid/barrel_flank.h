// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "numerics/scalar/interval.h"

/// The flank of the groove that a roller cuts into a barrel, its axis radial (docs/theory.md,
/// "Solids of barrel cams"). Lengths are in mm, angles in rad.
namespace camlaw::problems {

inline double squared(double x) { return x * x; }
inline Interval squared(const Interval& x) { return boost::numeric::square(x); }

/// Where the roller touches the flank at the distance q from the cam's axis when it rises by m for
/// each radian; `side` is 1 for the upper flank and -1 for the lower one. X is double or Interval.
/// rho is how far along the roller's axis that is from the cam's:
///   rho^4 - rho^2 (q^2 - m^2) - m^2 (q^2 - r^2) = 0, h^2 = rho^2 + m^2,
/// and the place is at the angle phi - side asin(r m / (q h)) and the height s + side r rho / h.
template <class X>
struct FlankContact {
  double roller_radius, side;
  X m, q;
  X root =
      square_root(squared(squared(q) + squared(m)) - 4.0 * squared(roller_radius) * squared(m));
  X square = (squared(q) - squared(m) + root) / 2.0;  ///< rho^2
  X rho = square_root(square);
  X h = square_root(square + squared(m));
  X sine = roller_radius * m / (q * h);  ///< of the angle by which the place lags, to the side

  X turned() const {
    using std::asin;
    return -side * asin(sine);
  }
  X raised() const { return side * roller_radius * rho / h; }
  /// The flank's slope along the circumference at the same q, by the angle: m q cos / rho, cos of
  /// the angle turned being rho / q.
  X slope() const { return m; }
  /// Its slope away from the axis at the same angle.
  X outward_slope() const { return -side * m * sine / rho; }
  /// By the roller's angle, of the place's angle; m1 is the derivative of m.
  X turned_by_angle(const X& m1) const {
    const X by_m = m * (squared(q) - squared(roller_radius) - square) / root;  // of rho^2, half
    return -side * roller_radius * (square - m * by_m) / (h * squared(h)) * m1 / rho;
  }
  /// By q at the same angle of the roller.
  X turned_by_distance() const {
    return side * roller_radius * m / rho * (h + squared(q) * h / root) / (q * squared(h));
  }

  static X square_root(const X& x) {
    using std::sqrt;
    return sqrt(x);
  }
};

}  // namespace camlaw::problems
