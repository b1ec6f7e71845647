// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "machines/contact/hertz.h"
#include "numerics/formula/expression.h"

/// Contact of two bodies that touch at a point and are pressed together over an ellipse
/// (docs/theory.md, "Crowned rollers"; Hertz; Johnson 1985, section 4.2).
namespace camlaw {

/// Complete elliptic integrals K and E of the modulus sqrt(1 - q^2).
struct EllipticIntegrals {
  Expression first, second;
};

/// (RB8) By arithmetic and geometric means of 1 and q: three steps, within 2e-5 of the integrals
/// for q from 0.02 to 1.
inline EllipticIntegrals elliptic_integrals(const Expression& q) {
  constexpr int kSteps = 3;
  Expression a = 1, b = q;
  Expression sum = Expression(0.5) * (1 - q * q);
  double weight = 1;
  for (int step = 0; step < kSteps; ++step) {
    const Expression half = Expression(0.5) * (a - b);
    const Expression mean = Expression(0.5) * (a + b);
    b = sqrt(a * b);
    a = mean;
    sum = sum + Expression(weight) * half * half;
    weight *= 2;
  }
  const Expression first = pi() / (a + b);
  return {first, first * (1 - sum)};
}

/// An ellipse over which a pressure is spread.
struct ContactEllipse {
  Expression half_length,
      half_width;          ///< m, where the two sums of the curvatures lie: along and across
  Expression pressure;     ///< the greatest, Pa
  Expression elongation;   ///< half_length / half_width, with or without a force
  Expression slenderness;  ///< k, the longer axis by the shorter one

  Expression lesser_half_axis() const { return lesser_of(half_length, half_width); }
};

/// (RB10) From the force, N, the sums of the curvatures across and along the ellipse, 1/m, and (K1)
/// E', Pa: with kappa_x the greater and kappa_y the lesser of the two, a^3 = 6 k^2 E F / (pi E'
/// (kappa_x + kappa_y)), b = a / k, p = 3 F / (2 pi a b) = E' (kappa_x + kappa_y) a / (4 k E),
/// which is 0 without a force. (RB9) Length by width k is one step from Hamrock and Brewe's
/// alpha^(2 / pi), alpha = kappa_x / kappa_y, towards the root of alpha = (k^2 E - K) / (K - E),
/// with the integrals where the step begins. The pressure is within 0.25 % of that of the root for
/// alpha from 1 to 150.
inline ContactEllipse contact_ellipse(const Expression& force, const Expression& across,
                                      const Expression& along, const Expression& modulus) {
  const Expression other = along, sum = across + other;
  const Expression ratio = greater_of(across, other) / lesser_of(across, other);
  const auto [first, second] = elliptic_integrals(power(ratio, -2 / std::numbers::pi));
  const Expression square = (ratio * (first - second) + first) / second;  // k^2
  const Expression stiff = 6 / (pi() * modulus);
  const Expression longer = power(stiff * (square * second * force / sum), 1.0 / 3);
  const Expression k = sqrt(square), shorter = longer / k, more = across - other;
  const Expression pressure = Expression(0.25) * modulus * (sum * longer / (k * second));
  return {by_side(more, longer, shorter), by_side(more, shorter, longer), pressure,
          by_side(more, k, 1 / k), k};
}

/// (RB16) The greatest shear stress below the middle of an ellipse, Pa, from its greatest pressure,
/// the longer axis by the shorter one k and Poisson's ratio: (g^(5/2) + (0.480 - 0.922 nu - 0.166 /
/// k) / (k + 3.055)) p, g = (sqrt 5 - 1) / 2. Within 0.5 % for k from 1 to 47 and nu from 0.25 to
/// 0.4; of a long ellipse it is that of the line contact (K5).
inline Expression crown_shear(const Expression& pressure, const Expression& slenderness,
                              const Expression& poisson_ratio) {
  const Expression more =
      poisson_ratio * ratio(-922, 1000) + ratio(48, 100) - ratio(166, 1000) / slenderness;
  return pressure * (max_shear(1) + more / (slenderness + ratio(3055, 1000)));
}
/// (RB17) How deep it is, m, from half the shorter axis b: (sqrt(g) - (2.85 - 2.68 nu) / (k^2 +
/// 3.41 k + 2.31)) b, within 1.5 % likewise.
inline Expression crown_shear_depth(const Expression& half_axis, const Expression& slenderness,
                                    const Expression& poisson_ratio) {
  const Expression less = poisson_ratio * ratio(-268, 100) + ratio(285, 100);
  const Expression square = slenderness * (slenderness + ratio(341, 100)) + ratio(231, 100);
  return half_axis * (shear_depth(1) - less / square);
}

}  // namespace camlaw
