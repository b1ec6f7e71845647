// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

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

}  // namespace camlaw
