// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "numerics/scalar/scalar.h"

/// Line contact of two parallel cylinders after Hertz (docs/theory.md, "Line contact").
namespace camlaw {

/// Two bodies of one material pressed together along a line.
template <class T>
struct LineContact {
  T youngs_modulus;  ///< E, Pa
  T poisson_ratio;   ///< nu

  /// (K1) E' = E / (1 - nu^2), of one body, Pa.
  T plane_modulus() const {
    return youngs_modulus / (number<T>(1) - poisson_ratio * poisson_ratio);
  }

  /// (K2) Greatest pressure, Pa, from the line load w, N/m, and the sum of the curvatures, 1/m:
  /// sigma = sqrt(w k E' / (2 pi)); 0.418 sqrt(w k E) for nu = 0.3. NaN for a load below 0.
  template <class X>
  X pressure(const X& line_load, const X& curvature) const {
    using std::sqrt;
    return sqrt(plane_modulus() / (number<T>(2) * pi<T>()) * (line_load * curvature));
  }

  /// (K3) Half the contact's width, m: a = sqrt(8 w / (pi k E')); 1.52 sqrt(w / (k E)) for nu =
  /// 0.3.
  template <class X>
  X half_width(const X& line_load, const X& curvature) const {
    using std::sqrt;
    return sqrt(number<T>(8) / (pi<T>() * plane_modulus()) * (line_load / curvature));
  }

  /// (K4) Approach of the axes of two solid cylinders, m, each held on the far side by an equal
  /// load: delta = 2 w (ln(16 R1 R2 / a^2) - 1) / (pi E'), with (K3) 2 w (ln(2 pi (R1 + R2) E' / w)
  /// - 1) / (pi E'). For a load above 0 and a much less than the radii.
  template <class X>
  X approach(const X& line_load, const T& radius, const T& other_radius) const {
    using std::log;
    const T modulus = pi<T>() * plane_modulus();
    const T scale = number<T>(2) * modulus * (radius + other_radius);
    return number<T>(2) / modulus *
           (line_load * (log(number<X>(1) / line_load * scale) - number<T>(1)));
  }
};

/// (sqrt 5 - 1) / 2, the number that places the greatest shear below a line contact.
inline constexpr double kGolden = 0.61803398874989484820;

/// (K5) Greatest shear stress below a line contact, Pa, from its greatest pressure: g^(5/2) sigma =
/// 0.3003 sigma, g = (sqrt 5 - 1) / 2, whatever Poisson's ratio.
template <class X>
X max_shear(const X& pressure) {
  const double share = kGolden * kGolden * std::sqrt(kGolden);
  return number<X>(share) * pressure;
}
/// (K6) How deep it is below the surface, m, from half the contact's width: sqrt(g) a = 0.7862 a.
template <class X>
X shear_depth(const X& half_width) {
  return number<X>(std::sqrt(kGolden)) * half_width;
}

}  // namespace camlaw
