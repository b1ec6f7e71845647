// SPDX-License-Identifier: MIT
#include "output/export/solid/cam_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "output/export/interference.h"
#include "output/export/tool_path.h"

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

/// How near the points of a curve come to the centre.
double least_distance(const PlaneCurve& curve) {
  constexpr int kLooks = 1440;
  double least = curve.at({curve.begin()}).at.norm();
  for (int i = 1; i <= kLooks; ++i) {
    const auto place = optim::even_place(curve.begin(), curve.end(), kLooks, i);
    least = std::min(least, curve.at(place).at.norm());
  }
  return least;
}

/// No point of a path is farther from the centre than its farthest control point.
double farthest(const CubicPath& path) {
  double most = 0;
  for (const Vector2d& point : path.control_points()) most = std::max(most, point.norm());
  return most;
}

CubicPath scaled(CubicPath path, double factor) {
  for (CubicPiece& piece : path.pieces) {
    for (Vector2d& point : piece.control) point *= factor;
  }
  return path;
}

const CubicPath& cubics_of(const ExportedCurve& curve) { return std::get<CubicPath>(curve.path); }

/// A closed curve as the edges of a solid, in mm: one for each of its smooth stretches, and at
/// least two.
SolidLoop loop_of(const PlaneCurve& curve, const ExportedCurve& exported, double mm) {
  CubicPath path = scaled(cubics_of(exported), mm);
  std::vector<double> angles = curve.breaks();
  angles.push_back(path.pieces[path.pieces.size() / 2].from);
  SolidLoop loop;
  for (CubicPath& run : path.smooth_runs(angles)) loop.emplace_back(std::move(run));
  return loop;
}

SolidLoop loop_of(const BoreOutline& bore) {
  SolidLoop loop{bore.arc};
  for (auto side = bore.keyway.rbegin(); side != bore.keyway.rend(); ++side) {
    loop.emplace_back(DrawnLine{side->to, side->from});
  }
  return loop;
}

/// Throws where a solid would have no such side: what is drawn with a note cannot be built.
void refuse_faults(const std::vector<PlaneCurve>& sides, const ProblemStatement& design) {
  std::vector<std::string> found;
  std::vector<PlaneCurve> curves = sides;
  for (const PlaneCurve& side : sides) {
    for (std::string& words : obstacles(side)) found.push_back(std::move(words));
  }
  for (PlaneCurve& pitch : cam_curves(design, "pitch")) curves.push_back(std::move(pitch));
  if (found.empty()) found = cuts_into_profiles(curves);
  if (!found.empty()) throw std::invalid_argument("a solid cannot be built: " + found.front());
}

/// The flank of a groove that is away from the cam's centre.
PlaneCurve outer_flank(const ProblemStatement& design, const PlaneCurve& profile) {
  const auto pitch = cam_curves(design, "pitch");
  const auto roller = own_size(design, "roller_radius");
  if (pitch.empty() || !roller) {
    throw std::invalid_argument(fmt::format("--groove: {} has no roller that could run in a groove",
                                            design.mechanism->name));
  }
  return pitch.front().beside("outer profile", outside_is_left(profile) ? *roller : -*roller);
}

void check_groove(const GrooveSize& groove, double width, double reach) {
  if (groove.depth >= width) {
    throw std::invalid_argument(
        fmt::format("--groove: a groove {:.6g} mm deep goes through a cam of {:.6g} mm in width",
                    groove.depth, width));
  }
  if (groove.blank_radius <= reach) {
    throw std::invalid_argument(fmt::format(
        "--blank: the groove reaches {:.6g} mm from the centre, which a disc of {:.6g} mm in "
        "radius does not hold",
        reach, groove.blank_radius));
  }
}

}  // namespace

CamSolid cam_solid(const ProblemStatement& design, const SolidSettings& settings,
                   const ExportAccuracy& accuracy) {
  const auto found = cam_curves(design, settings.curve);
  if (found.empty() || !found.front().is_closed()) {
    throw std::invalid_argument(
        fmt::format("a solid is built of disc cams, whose profile is closed; {} has no such {}",
                    design.mechanism->name, settings.curve));
  }
  std::vector<PlaneCurve> sides{found.front()};
  if (settings.groove) sides.push_back(outer_flank(design, sides.front()));
  refuse_faults(sides, design);
  CamSolid result;
  std::vector<SolidLoop> loops;
  const double mm = accuracy.unit.mm;
  for (const PlaneCurve& side : sides) {
    result.curves.push_back(exported(side, CurveForm::Spline, accuracy));
    loops.push_back(loop_of(side, result.curves.back(), mm));
  }
  Prism& body = result.solid.body;
  body.to = settings.width;
  if (settings.groove) {
    const GrooveSize& groove = *settings.groove;
    check_groove(groove, settings.width, mm * farthest(cubics_of(result.curves.back())));
    body.loops.push_back({DrawnArc{{0, 0}, groove.blank_radius}});
    result.solid.cuts.push_back(
        {{loops[1], loops[0]}, settings.width - groove.depth, settings.width});
  } else {
    body.loops.push_back(loops.front());
  }
  const PlaneCurve& profile = sides.front();
  if (const auto bore = bore_of(design, settings.bore_radius, settings.keyway)) {
    const Vector2d zero = profile.at({profile.begin()}).at;
    body.loops.push_back(loop_of(outline_of(*bore, zero, least_distance(profile), "the profile")));
  }
  return result;
}

}  // namespace camlaw::problems
