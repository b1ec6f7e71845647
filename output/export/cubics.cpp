// SPDX-License-Identifier: MIT
#include "output/export/cubics.h"

#include <algorithm>

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

/// De Casteljau.
Vector2d point_of(const CubicPiece& piece, double share) {
  std::array<Vector2d, 4> p = piece.control;
  for (std::size_t level = 3; level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) p[i] += share * (p[i + 1] - p[i]);
  }
  return p[0];
}

CubicPiece cubic_of(const CurveSpan& span) {
  const double third = (span.to.angle - span.from.angle) / 3;
  const Vector2d a = span.begin.at, b = span.end.at;
  return {span.from.angle,
          span.to.angle,
          {a, a + third * span.begin.slope, b - third * span.end.slope, b},
          0};
}

/// No point of the curve over a stretch is farther than this from the cubic's at the same angle.
/// Between two shares t apart a cubic departs from the line between them by at most t^2 / 8 of its
/// largest second derivative, which it has at an end.
double cubic_bound(const CubicPiece& piece, const CurveStretch& stretch, double from, double to) {
  const auto& p = piece.control;
  const double bend =
      6 * std::max((p[0] - 2 * p[1] + p[2]).norm(), (p[1] - 2 * p[2] + p[3]).norm());
  const double length = piece.to - piece.from, share = (to - from) / length;
  const double apart = std::max((stretch.a - point_of(piece, (from - piece.from) / length)).norm(),
                                (stretch.b - point_of(piece, (to - piece.from) / length)).norm());
  return apart + stretch.bow + share * share / 8 * bend;
}

}  // namespace

CubicPath cubics_within(const PlaneCurve& whole, double tolerance) {
  // At a cusp the curve's derivative is 0, and a cubic over it would round the cusp off.
  const PlaneCurve curve = whole.broken_at(cusps(whole));
  // A jump takes no angle; a spline's knots must rise all the same.
  const double jump = 1e-9 * (curve.end() - curve.begin());
  auto fit = fitted(
      curve, tolerance, {},
      [&](const CurveSpan& span, double within) {
        CubicPiece piece = cubic_of(span);
        const double length = span.to.angle - span.from.angle;
        piece.deviation =
            worst_over(curve, span, within, [&](optim::Place place, const Vector2d& p) {
              return (p - point_of(piece, (place.angle - span.from.angle) / length)).norm();
            });
        return piece;
      },
      cubic_bound,
      [&](double angle, const CurvePoint& a, const CurvePoint& b) {
        const Vector2d third = (b.at - a.at) / 3;
        return CubicPiece{angle - jump, angle, {a.at, a.at + third, b.at - third, b.at}, 0};
      });
  if (curve.is_closed()) fit.pieces.back().control[3] = fit.pieces.front().control[0];
  return {std::move(fit.pieces), fit.worst.most, fit.worst.proved};
}

bool CubicPath::is_cusp(std::size_t i) const {
  constexpr double kRounding = 1e-9;  // of a piece's size: the slope there is 0 but for that
  const auto &a = pieces[i].control, &b = pieces[i + 1].control;
  const Vector2d before = a[3] - a[2], after = b[1] - b[0];
  const bool is_still = before.norm() <= kRounding * (a[3] - a[0]).norm() &&
                        after.norm() <= kRounding * (b[3] - b[0]).norm();
  return is_still || before.dot(after) < 0;
}

bool CubicPath::is_smooth(std::size_t i) const {
  if (is_cusp(i)) return false;
  constexpr double kRounding = 1e-9;  // of the derivative: control points are rounded sums
  const CubicPiece &a = pieces[i], &b = pieces[i + 1];
  const Vector2d before = (a.control[3] - a.control[2]) / (a.to - a.from);
  const Vector2d after = (b.control[1] - b.control[0]) / (b.to - b.from);
  return (before - after).norm() <= kRounding * std::max(before.norm(), after.norm());
}

std::vector<double> CubicPath::knots() const {
  std::vector<double> knots(4, pieces.front().from);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    knots.insert(knots.end(), is_smooth(i) ? 2 : 3, pieces[i + 1].from);
  }
  knots.insert(knots.end(), 4, pieces.back().to);
  return knots;
}

std::vector<Vector2d> CubicPath::control_points() const {
  std::vector<Vector2d> points{pieces.front().control[0]};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& control = pieces[i].control;
    points.insert(points.end(), {control[1], control[2]});
    if (i + 1 == pieces.size() || !is_smooth(i)) points.push_back(control[3]);
  }
  return points;
}

template <class Ends>
std::vector<CubicPath> CubicPath::runs(const Ends& ends) const {
  std::vector<CubicPath> result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i == 0 || ends(i - 1)) {
      if (i > 0) result.back().pieces.back().control[3] = pieces[i].control[0];
      result.push_back({{}, worst, proved});
    }
    result.back().pieces.push_back(pieces[i]);
  }
  return result;
}

std::vector<CubicPath> CubicPath::smooth_runs(const std::vector<double>& angles) const {
  return runs([&](std::size_t i) {
    return !is_smooth(i) || std::find(angles.begin(), angles.end(), pieces[i].to) != angles.end();
  });
}

std::vector<CubicPath> CubicPath::runs_between_cusps() const {
  return runs([&](std::size_t i) { return is_cusp(i); });
}

}  // namespace camlaw::problems
