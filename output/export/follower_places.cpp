// SPDX-License-Identifier: MIT
#include "output/export/follower_places.h"

#include <cmath>
#include <numbers>

#include "problems/statement/parameters.h"

namespace camlaw::problems {

using Eigen::Vector2d;

RollerPair conjugate_rollers(const ProblemStatement& design, double displacement) {
  const double prime = constant_of(design, "base_radius") + constant_of(design, "roller_radius");
  const double e = constant_of(design, "offset");
  const Vector2d main(e, std::sqrt(prime * prime - e * e) + displacement);
  return {main, main - Vector2d(0, constant_of(design, "roller_distance"))};
}

FaceLine sliding_face(const ProblemStatement& design, double displacement) {
  return {{0, constant_of(design, "base_radius") + displacement}, {1, 0}};
}

FaceLine swinging_face(const ProblemStatement& design, double displacement) {
  const double distance = constant_of(design, "pivot_distance");
  const double offset = constant_of(design, "face_offset");
  const double lowest = std::asin((constant_of(design, "base_radius") + offset) / distance);
  const double psi = lowest + displacement * std::numbers::pi / 180;
  const double c = std::cos(psi), s = std::sin(psi);
  return {{distance - offset * s, -offset * c}, {-c, s}};
}

Vector2d balancing_roller(const ProblemStatement& design, double displacement) {
  return {0,
          constant_of(design, "base_radius") + constant_of(design, "roller_radius") + displacement};
}

}  // namespace camlaw::problems
