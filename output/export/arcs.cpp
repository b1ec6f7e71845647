// SPDX-License-Identifier: MIT
#include "output/export/arcs.h"

#include <array>
#include <numbers>

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

/// An arc that rises less than this above its chord, mm, is a line.
constexpr double kFlat = 1e-9;
/// Centres and radii nearer than this, mm, are one circle's.
constexpr double kSame = 1e-8;

/// The arc that leaves a point in a direction and meets another; a line where it is too flat.
ArcPiece arc_of(const Vector2d& from, const Vector2d& direction, const Vector2d& to,
                double most_radius) {
  const Vector2d way = to - from;
  const double length = way.squaredNorm();
  const double curvature = length > 0 ? 2 * cross(direction, way) / length : 0;
  const bool flat = std::abs(curvature) * length < 8 * kFlat;
  if (flat || std::abs(curvature) * most_radius < 1) return {from, to, from, 0};
  const Vector2d normal(-direction.y(), direction.x());
  return {from, to, from + normal / curvature,
          2 * std::atan2(cross(direction, way), direction.dot(way))};
}

struct Biarc {
  std::array<ArcPiece, 2> arcs;
  double deviation = 0;

  double distance(const Vector2d& point) const {
    return std::min(arcs[0].distance(point), arcs[1].distance(point));
  }

  double bound(const CurveStretch& stretch) const {
    // A point is no farther from the path than another one beside it, and what is between.
    const double beside =
        distance(0.5 * (stretch.a + stretch.b)) + (stretch.b - stretch.a).norm() / 2 + stretch.bow;
    return std::min({arcs[0].bound(stretch), arcs[1].bound(stretch), beside});
  }
};

Biarc biarc_of(const CurveSpan& span, double most_radius) {
  const Vector2d a = span.begin.at, b = span.end.at, way = b - a;
  const Vector2d s = span.begin.slope.normalized(), t = span.end.slope.normalized();
  const double along = way.dot(s + t), length = way.squaredNorm();
  const double root = std::sqrt(along * along + 2 * (1 - s.dot(t)) * length);
  const double d = along + root > 0 ? length / (along + root) : 0;
  const Vector2d middle = 0.5 * ((a + d * s) + (b - d * t));
  ArcPiece back = arc_of(b, -t, middle, most_radius);
  std::swap(back.from, back.to);
  back.sweep = -back.sweep;
  return {{arc_of(a, s, middle, most_radius), back}, 0};
}

bool has_tangents(const CurveSpan& span) {
  return span.begin.slope.norm() > 0 && span.end.slope.norm() > 0 && span.begin.slope.allFinite() &&
         span.end.slope.allFinite();
}

Biarc line_of(const Vector2d& a, const Vector2d& b) {
  const Vector2d middle = 0.5 * (a + b);
  return {{ArcPiece{a, middle, a, 0}, ArcPiece{middle, b, middle, 0}}, 0};
}

bool continues(const ArcPiece& a, const ArcPiece& b) {
  // From a full turn on an arc's two ends would be one and not tell which way it goes.
  constexpr double kMostSweep = 1.9 * std::numbers::pi;
  if (a.is_line() != b.is_line()) return false;
  if (a.is_line()) {
    const Vector2d way = b.to - a.from;
    return distance_to_line(a.to, a.from, b.to) < kFlat && (a.to - a.from).dot(way) >= 0 &&
           (b.to - b.from).dot(way) >= 0;
  }
  return (a.centre - b.centre).norm() < kSame && std::abs(a.radius() - b.radius()) < kSame &&
         a.sweep * b.sweep > 0 && std::abs(a.sweep + b.sweep) < kMostSweep;
}

void append(const ArcPiece& piece, std::vector<ArcPiece>& path) {
  if ((piece.to - piece.from).norm() == 0) return;
  if (path.empty() || !continues(path.back(), piece)) {
    path.push_back(piece);
    return;
  }
  path.back().to = piece.to;
  path.back().sweep += piece.sweep;
}

}  // namespace

double ArcPiece::distance(const Vector2d& point) const {
  if (is_line()) return distance_to_line(point, from, to);
  const Vector2d start = from - centre, here = point - centre;
  double turn = std::atan2(cross(start, here), start.dot(here));
  if (sweep < 0) turn = -turn;
  if (turn < 0) turn += 2 * std::numbers::pi;
  if (turn <= std::abs(sweep)) return std::abs(here.norm() - radius());
  return std::min((point - from).norm(), (point - to).norm());
}

double ArcPiece::bound(const CurveStretch& stretch) const {
  if (is_line()) return line_bound(stretch, from, to);
  // Between its ends' directions an arc is as far as its circle. Less than half a turn is convex:
  // a straight line with both ends there stays there.
  const auto is_beside = [&](const Vector2d& point) {
    const Vector2d start = from - centre, here = point - centre;
    double turn = std::atan2(cross(start, here), start.dot(here));
    if (sweep < 0) turn = -turn;
    return turn >= 0 && turn <= std::abs(sweep);
  };
  if (!(std::abs(sweep) < std::numbers::pi) || !is_beside(stretch.a) || !is_beside(stretch.b)) {
    return std::numeric_limits<double>::infinity();
  }
  const double farthest = std::max((stretch.a - centre).norm(), (stretch.b - centre).norm());
  const double nearest = distance_to_line(centre, stretch.a, stretch.b);
  return std::max(farthest - radius(), radius() - nearest) + stretch.bow;
}

ArcPath arcs_within(const PlaneCurve& curve, double tolerance, double most_radius) {
  const auto fit = fitted(
      curve, tolerance, {},
      [&](const CurveSpan& span, double within) {
        Biarc biarc =
            has_tangents(span) ? biarc_of(span, most_radius) : line_of(span.begin.at, span.end.at);
        biarc.deviation = worst_over(curve, span, within, [&](optim::Place, const Vector2d& p) {
          return biarc.distance(p);
        });
        return biarc;
      },
      [](const Biarc& biarc, const CurveStretch& stretch, double, double) {
        return biarc.bound(stretch);
      },
      [](double, const CurvePoint& a, const CurvePoint& b) { return line_of(a.at, b.at); });
  ArcPath path{{}, fit.worst.most, fit.worst.proved};
  for (const Biarc& biarc : fit.pieces) {
    for (const ArcPiece& arc : biarc.arcs) append(arc, path.pieces);
  }
  if (curve.is_closed()) path.pieces.back().to = path.pieces.front().from;
  return path;
}

}  // namespace camlaw::problems
