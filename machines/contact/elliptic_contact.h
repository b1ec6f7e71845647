// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "machines/contact/hertz.h"
#include "numerics/scalar/by_side.h"
#include "numerics/scalar/extremes.h"
#include "numerics/scalar/power.h"
#include "numerics/scalar/scalar.h"

/// Contact of two bodies that touch at a point and are pressed together over an ellipse
/// (docs/theory.md, "Crowned rollers"; Hertz; Johnson 1985, section 4.2).
namespace camlaw {

/// Complete elliptic integrals K and E of the modulus sqrt(1 - q^2).
template <class X>
struct EllipticIntegrals {
  X first, second;
};

/// (RB8) By arithmetic and geometric means of 1 and q: three steps, within 2e-5 of the integrals
/// for q from 0.02 to 1.
template <class X>
EllipticIntegrals<X> elliptic_integrals(const X& q) {
  using std::sqrt;
  constexpr int kSteps = 3;
  X a = number<X>(1), b = q;
  X sum = number<X>(0.5) * (number<X>(1) - q * q);
  double weight = 1;
  for (int step = 0; step < kSteps; ++step) {
    const X half = number<X>(0.5) * (a - b);
    const X mean = number<X>(0.5) * (a + b);
    b = sqrt(a * b);
    a = mean;
    sum = sum + number<X>(weight) * half * half;
    weight *= 2;
  }
  const X first = pi<X>() / (a + b);
  return {first, first * (number<X>(1) - sum)};
}

/// An ellipse over which a pressure is spread.
template <class X>
struct ContactEllipse {
  X half_length, half_width;  ///< m, where the two sums of the curvatures lie: along and across
  X pressure;                 ///< the greatest, Pa
  X elongation;               ///< half_length / half_width, with or without a force
  X slenderness;              ///< k, the longer axis by the shorter one

  X lesser_half_axis() const { return lesser_of(half_length, half_width); }
};

/// (RB10) From the force, N, the sums of the curvatures across and along the ellipse, 1/m, and (K1)
/// E', Pa: with kappa_x the greater and kappa_y the lesser of the two, a^3 = 6 k^2 E F / (pi E'
/// (kappa_x + kappa_y)), b = a / k, p = 3 F / (2 pi a b) = E' (kappa_x + kappa_y) a / (4 k E),
/// which is 0 without a force. (RB9) Length by width k is one step from Hamrock and Brewe's
/// alpha^(2 / pi), alpha = kappa_x / kappa_y, towards the root of alpha = (k^2 E - K) / (K - E),
/// with the integrals where the step begins. The pressure is within 0.25 % of that of the root for
/// alpha from 1 to 150.
template <class T, class K, class X>
ContactEllipse<X> contact_ellipse(const X& force, const X& across, const K& along,
                                  const T& modulus) {
  const X other = number<X>(0) + along, sum = across + other;
  const X ratio = greater_of(across, other) / lesser_of(across, other);
  const auto [first, second] = elliptic_integrals(X(power(ratio, -2 / std::numbers::pi)));
  const X square = (ratio * (first - second) + first) / second;  // k^2
  const T stiff = number<T>(6) / (pi<T>() * modulus);
  const X longer = power(X(stiff * (square * second * force / sum)), 1.0 / 3);
  using std::sqrt;
  const X k = sqrt(square), shorter = longer / k, more = across - other;
  const X pressure = number<T>(0.25) * modulus * (sum * longer / (k * second));
  return {by_side(more, longer, shorter), by_side(more, shorter, longer), pressure,
          by_side(more, k, X(number<X>(1) / k)), k};
}

/// (RB16) The greatest shear stress below the middle of an ellipse, Pa, from its greatest pressure,
/// the longer axis by the shorter one k and Poisson's ratio: (g^(5/2) + (0.480 - 0.922 nu - 0.166 /
/// k) / (k + 3.055)) p, g = (sqrt 5 - 1) / 2. Within 0.5 % for k from 1 to 47 and nu from 0.25 to
/// 0.4; of a long ellipse it is that of the line contact (K5).
template <class T, class X>
X crown_shear(const X& pressure, const X& slenderness, const T& poisson_ratio) {
  const X more =
      poisson_ratio * number<X>(-0.922) + number<X>(0.48) - number<X>(0.166) / slenderness;
  return pressure * (max_shear(number<X>(1)) + more / (slenderness + number<X>(3.055)));
}
/// (RB17) How deep it is, m, from half the shorter axis b: (sqrt(g) - (2.85 - 2.68 nu) / (k^2 +
/// 3.41 k + 2.31)) b, within 1.5 % likewise.
template <class T, class X>
X crown_shear_depth(const X& half_axis, const X& slenderness, const T& poisson_ratio) {
  const X less = poisson_ratio * number<X>(-2.68) + number<X>(2.85);
  const X square = slenderness * (slenderness + number<X>(3.41)) + number<X>(2.31);
  return half_axis * (shear_depth(number<X>(1)) - less / square);
}

}  // namespace camlaw
