// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace camlaw {

/// Gauss-Legendre quadrature over (-1, 1): the places from the middle to the right, increasing, and
/// their weights. Those on the left mirror them; 0 is among the places where the points are odd.
struct GaussLegendre {
  std::span<const double> places, weights;
};

/// The rule of so many points, exact for polynomials of degree 2 points - 1. Boost's, whose headers
/// are compiled here alone. Throws std::invalid_argument where the points are not 10, 13 or 30.
const GaussLegendre& gauss_legendre(int points);

}  // namespace camlaw
