// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "numerics/formula/expression.h"

/// Line contact of two parallel cylinders after Hertz (docs/theory.md, "Line contact").
namespace camlaw {

/// Two bodies of one material pressed together along a line.
struct LineContact {
  Expression youngs_modulus;  ///< E, Pa
  Expression poisson_ratio;   ///< nu

  /// (K1) E' = E / (1 - nu^2), of one body, Pa.
  Expression plane_modulus() const { return youngs_modulus / (1 - poisson_ratio * poisson_ratio); }

  /// (K2) Greatest pressure, Pa, from the line load w, N/m, and the sum of the curvatures, 1/m:
  /// sigma = sqrt(w k E' / (2 pi)); 0.418 sqrt(w k E) for nu = 0.3. NaN for a load below 0.
  Expression pressure(const Expression& line_load, const Expression& curvature) const {
    return sqrt(plane_modulus() / (2 * pi()) * (line_load * curvature));
  }

  /// (K3) Half the contact's width, m: a = sqrt(8 w / (pi k E')); 1.52 sqrt(w / (k E)) for nu =
  /// 0.3.
  Expression half_width(const Expression& line_load, const Expression& curvature) const {
    return sqrt(8 / (pi() * plane_modulus()) * (line_load / curvature));
  }

  /// (K4) Approach of the axes of two solid cylinders, m, each held on the far side by an equal
  /// load: delta = 2 w (ln(16 R1 R2 / a^2) - 1) / (pi E'), with (K3) 2 w (ln(2 pi (R1 + R2) E' / w)
  /// - 1) / (pi E'). For a load above 0 and a much less than the radii.
  Expression approach(const Expression& line_load, const Expression& radius,
                      const Expression& other_radius) const {
    const Expression modulus = pi() * plane_modulus();
    const Expression scale = 2 * modulus * (radius + other_radius);
    return 2 / modulus * (line_load * (log(1 / line_load * scale) - 1));
  }
};

/// (sqrt 5 - 1) / 2, the number that places the greatest shear below a line contact.
inline constexpr double kGolden = 0.61803398874989484820;
inline Interval golden_bounds() { return (sqrt(Interval(5)) - Interval(1)) / Interval(2); }

/// (K5) Greatest shear stress below a line contact, Pa, from its greatest pressure: g^(5/2) sigma =
/// 0.3003 sigma, g = (sqrt 5 - 1) / 2, whatever Poisson's ratio.
inline Expression max_shear(const Expression& pressure) {
  const double share = kGolden * kGolden * std::sqrt(kGolden);
  const Interval g = golden_bounds(), bounds = g * g * sqrt(g);
  return Expression(share, bounds.lower(), bounds.upper()) * pressure;
}
/// (K6) How deep it is below the surface, m, from half the contact's width: sqrt(g) a = 0.7862 a.
inline Expression shear_depth(const Expression& half_width) {
  const Interval bounds = sqrt(golden_bounds());
  return Expression(std::sqrt(kGolden), bounds.lower(), bounds.upper()) * half_width;
}

}  // namespace camlaw
