// SPDX-License-Identifier: MIT
#include "output/export/solid/solid.h"

#include <cmath>
#include <numbers>

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

double half_cross(const Vector2d& a, const Vector2d& b) {
  return (a.x() * b.y() - a.y() * b.x()) / 2;
}

double swept(const DrawnLine& line) { return half_cross(line.from, line.to); }

/// With x = c + r e(t): the integral of (r^2 + r c . e(t)) / 2.
double swept(const DrawnArc& arc) {
  constexpr double kPerDegree = std::numbers::pi / 180;
  const double from = kPerDegree * arc.from, to = kPerDegree * arc.to, r = arc.radius;
  const Vector2d change(std::sin(to) - std::sin(from), std::cos(from) - std::cos(to));
  return (r * r * (to - from) + r * arc.centre.dot(change)) / 2;
}

/// Of Bezier points, exact: of the integral of x y' - y x' of two Bernstein polynomials of degree 3
/// the share of each pair of points is rational.
double swept(const CubicPath& path) {
  double area = 0;
  for (const CubicPiece& piece : path.pieces) {
    const auto& p = piece.control;
    area += 0.6 * (half_cross(p[0], p[1]) + half_cross(p[2], p[3])) +
            0.3 * (half_cross(p[0], p[2]) + half_cross(p[1], p[2]) + half_cross(p[1], p[3])) +
            0.1 * half_cross(p[0], p[3]);
  }
  return area;
}

double area_of(const Prism& prism) {
  double area = area_of(prism.loops.front());
  for (std::size_t i = 1; i < prism.loops.size(); ++i) area -= area_of(prism.loops[i]);
  return area;
}

}  // namespace

double area_of(const SolidLoop& loop) {
  double area = 0;
  for (const SolidEdge& edge : loop) {
    area += std::visit([](const auto& e) { return swept(e); }, edge);
  }
  return std::abs(area);
}

double volume_of(const Solid& solid) {
  double volume = area_of(solid.body) * (solid.body.to - solid.body.from);
  for (const Prism& cut : solid.cuts) volume -= area_of(cut) * (cut.to - cut.from);
  if (solid.groove) volume -= groove_volume(solid.groove->lower, solid.groove->upper);
  return volume;
}

}  // namespace camlaw::problems
