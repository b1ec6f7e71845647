// SPDX-License-Identifier: MIT
#include "output/export/exported_curve.h"

#include <limits>
#include <numbers>

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

/// Where an arc reaches farthest along the axes, ends included.
std::vector<Vector2d> reach(const ArcPiece& arc) {
  std::vector<Vector2d> points{arc.from, arc.to};
  if (arc.is_line()) return points;
  for (const Vector2d& axis : {Vector2d(1, 0), Vector2d(0, 1), Vector2d(-1, 0), Vector2d(0, -1)}) {
    const Vector2d top = arc.centre + arc.radius() * axis;
    if (arc.distance(top) < 1e-9 * arc.radius()) points.push_back(top);
  }
  return points;
}

std::vector<Vector2d> reach(const ExportedCurve& curve) {
  if (const auto* cubics = std::get_if<CubicPath>(&curve.path)) return cubics->control_points();
  std::vector<Vector2d> points = curve.joints();
  if (const auto* arcs = std::get_if<ArcPath>(&curve.path)) {
    for (const ArcPiece& arc : arcs->pieces) {
      for (const Vector2d& point : reach(arc)) points.push_back(point);
    }
  }
  return points;
}

}  // namespace

double ExportedCurve::worst() const {
  return std::visit([](const auto& p) { return p.worst; }, path);
}

bool ExportedCurve::proved() const {
  return std::visit([](const auto& p) { return p.proved; }, path);
}

std::size_t ExportedCurve::size() const {
  if (const auto* chords = std::get_if<Chords>(&path)) return chords->points.size();
  if (const auto* arcs = std::get_if<ArcPath>(&path)) return arcs->pieces.size();
  return std::get<CubicPath>(path).pieces.size();
}

std::vector<Vector2d> ExportedCurve::joints() const {
  std::vector<Vector2d> points;
  if (const auto* chords = std::get_if<Chords>(&path)) {
    for (const ChordPoint& p : chords->points) points.push_back(p.at);
  } else if (const auto* arcs = std::get_if<ArcPath>(&path)) {
    for (const ArcPiece& p : arcs->pieces) points.push_back(p.from);
    points.push_back(arcs->pieces.back().to);
  } else {
    const auto& pieces = std::get<CubicPath>(path).pieces;
    for (const CubicPiece& p : pieces) points.push_back(p.control[0]);
    points.push_back(pieces.back().control[3]);
  }
  return points;
}

ExportedCurve exported(const PlaneCurve& mm_curve, CurveForm form, const ExportAccuracy& accuracy) {
  const PlaneCurve curve = mm_curve.in(accuracy.unit);
  ExportedCurve result{curve.name(), curve.is_closed(), Chords{}};
  if (accuracy.step) {
    result.path = chords_at_steps(curve, *accuracy.step, accuracy.decimals);
  } else if (form == CurveForm::Lines) {
    result.path = chords_within(curve, accuracy.tolerance, accuracy.decimals);
  } else if (form == CurveForm::Arcs) {
    result.path = arcs_within(curve, accuracy.tolerance, accuracy.most_radius);
  } else {
    result.path = cubics_within(curve, accuracy.tolerance);
  }
  return result;
}

Extent extent_of(const std::vector<ExportedCurve>& curves) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Extent extent{{kFar, kFar}, {-kFar, -kFar}};
  for (const ExportedCurve& curve : curves) {
    for (const Vector2d& point : reach(curve)) {
      extent.low = extent.low.cwiseMin(point);
      extent.high = extent.high.cwiseMax(point);
    }
  }
  return extent;
}

std::string plain_text(const std::string& text) {
  constexpr std::size_t kMost = 200;  // a line of a comment; a title may be far longer
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;  // of a character that is there as '?' already
    const bool plain = byte >= 0x20 && byte < 0x7F && c != '(' && c != ')' && c != '%';
    result += plain ? c : c == '(' || c == ')' ? ' ' : '?';
  }
  return result.size() > kMost ? result.substr(0, kMost) + " ..." : result;
}

}  // namespace camlaw::problems
