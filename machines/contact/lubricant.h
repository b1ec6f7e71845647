// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/formula/expression.h"

namespace camlaw {

/// What lies between two bodies that roll on one another along a line, and how rough they are
/// (docs/theory.md, "Lubricant film"). Fields in SI units.
struct Lubricant {
  Expression viscosity;           ///< eta, Pa s, at the contact's inlet, without pressure
  Expression pressure_viscosity;  ///< alpha, 1/Pa: viscosity grows as exp(alpha p)
  Expression roughness;           ///< R_q, m, of both surfaces: sqrt(R_q1^2 + R_q2^2)

  /// (RB7) Least film of a line contact, m, after Dowson and Higginson: h = 2.65 R U^0.7 G^0.54
  /// W^-0.13 with U = eta u / (E' R), G = alpha E', W = w / (E' R), from the line load w, N/m, the
  /// sum of the curvatures 1 / R, 1/m, the mean speed u of the surfaces towards the contact, m/s,
  /// and (K1) E', Pa.
  Expression film(const Expression& line_load, const Expression& curvature, const Expression& speed,
                  const Expression& modulus) const {
    const Expression moved = viscosity / modulus * (speed * curvature);
    const Expression pressed = 1 / modulus * (line_load * curvature);
    return ratio(265, 100) * power(pressure_viscosity * modulus, 0.54) *
           (power(moved, 0.7) * power(pressed, -0.13) / curvature);
  }

  /// (RB18) Least film of a contact ellipse, m, after Hamrock and Dowson: h = 3.63 R U^0.68 G^0.49
  /// W^-0.073 (1 - exp(-0.68 k)) with U, G and R as above and W = F / (E' R^2), from the force F,
  /// N, the sum of the curvatures 1 / R along the motion, 1/m, and the ellipse's length, square to
  /// the motion, by its width.
  Expression point_film(const Expression& force, const Expression& curvature,
                        const Expression& elongation, const Expression& speed,
                        const Expression& modulus) const {
    const Expression moved = viscosity / modulus * (speed * curvature);
    const Expression pressed = 1 / modulus * (force * (curvature * curvature));
    const Expression closed = 1 - exp(ratio(-68, 100) * elongation);
    return ratio(363, 100) * power(pressure_viscosity * modulus, 0.49) *
           (power(moved, 0.68) * power(pressed, -0.073) / curvature * closed);
  }
};

}  // namespace camlaw
