// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "machines/contact/hertz.h"
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
  X half_length, half_width;  ///< m, along the smaller and the greater of the curvatures
  X pressure;                 ///< the greatest, Pa
  X elongation;               ///< k, length by width, with or without a force
};

/// (RB10) From the force, N, the sums of the curvatures across and along the ellipse, 1/m, the
/// first the greater, and (K1) E', Pa: a^3 = 6 k^2 E F / (pi E' (kappa_x + kappa_y)), b = a / k, p
/// = 3 F / (2 pi a b) = E' (kappa_x + kappa_y) a / (4 k E), which is 0 without a force. (RB9)
/// Length by width k is one step from Hamrock and Brewe's alpha^(2 / pi), alpha = kappa_x /
/// kappa_y, towards the root of alpha = (k^2 E - K) / (K - E), with the integrals where the step
/// begins. The pressure is within 0.25 % of that of the root for alpha from 1 to 150.
template <class T, class K, class X>
ContactEllipse<X> contact_ellipse(const X& force, const X& across, const K& along,
                                  const T& modulus) {
  const X ratio = number<K>(1) / along * across;
  const auto [first, second] = elliptic_integrals(X(power(ratio, -2 / std::numbers::pi)));
  const X square = (ratio * (first - second) + first) / second;  // k^2
  const T stiff = number<T>(6) / (pi<T>() * modulus);
  const X length = power(X(stiff * (square * second * force / (across + along))), 1.0 / 3);
  using std::sqrt;
  const X longer = sqrt(square);  // k
  const X pressure = number<T>(0.25) * modulus * ((across + along) * length / (longer * second));
  return {length, length / longer, pressure, longer};
}

/// (RB16) The greatest shear stress below the middle of an ellipse, Pa, from its greatest pressure,
/// its length by width k and Poisson's ratio: (g^(5/2) + (0.480 - 0.922 nu - 0.166 / k) / (k +
/// 3.055)) p, g = (sqrt 5 - 1) / 2. Within 0.5 % for k from 1 to 47 and nu from 0.25 to 0.4; of a
/// long ellipse it is that of the line contact (K5).
template <class T, class X>
X crown_shear(const X& pressure, const X& elongation, const T& poisson_ratio) {
  const X more =
      poisson_ratio * number<X>(-0.922) + number<X>(0.48) - number<X>(0.166) / elongation;
  return pressure * (max_shear(number<X>(1)) + more / (elongation + number<X>(3.055)));
}
/// (RB17) How deep it is, m, from half the ellipse's width b: (sqrt(g) - (2.85 - 2.68 nu) / (k^2 +
/// 3.41 k + 2.31)) b, within 1.5 % likewise.
template <class T, class X>
X crown_shear_depth(const X& half_width, const X& elongation, const T& poisson_ratio) {
  const X less = poisson_ratio * number<X>(-2.68) + number<X>(2.85);
  const X square = elongation * (elongation + number<X>(3.41)) + number<X>(2.31);
  return half_width * (shear_depth(number<X>(1)) - less / square);
}

}  // namespace camlaw
