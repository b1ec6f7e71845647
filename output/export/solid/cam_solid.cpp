// SPDX-License-Identifier: MIT
#include "output/export/solid/cam_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "output/export/interference.h"
#include "output/export/shaft_place.h"
#include "output/export/tool_path.h"

namespace camlaw::problems {
namespace {

using Eigen::Vector2d;

/// How near the points of a curve come to the centre.
double least_distance(const PlaneCurve& curve) {
  // A quarter of a degree: 100 mm per rad^2 hide 0.0003 mm between two places.
  constexpr int kPlaces = 1440;
  double least = curve.at({curve.begin()}).at.norm();
  for (int i = 1; i <= kPlaces; ++i) {
    const auto place = optim::even_place(curve.begin(), curve.end(), kPlaces, i);
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
  const double radius = groove.blank_radius.value();
  if (groove.depth >= width) {
    throw std::invalid_argument(
        fmt::format("--groove: a groove {:.6g} mm deep goes through a cam of {:.6g} mm in width",
                    groove.depth, width));
  }
  if (radius <= reach) {
    throw std::invalid_argument(fmt::format(
        "--blank: the groove reaches {:.6g} mm from the centre, which a disc of {:.6g} mm in "
        "radius does not hold",
        reach, radius));
  }
}

/// The lowest and the highest Bernstein coefficient: the surface is between them.
std::pair<double, double> heights_of(const FlankSurface& surface) {
  std::pair<double, double> heights{1e300, -1e300};
  for (std::size_t i = 0; i < surface.angles(); ++i) {
    for (std::size_t j = 0; j < surface.distances(); ++j) {
      for (const auto& row : surface.patch(i, j)) {
        const auto [low, high] = std::minmax_element(row.begin(), row.end());
        heights = {std::min(heights.first, *low), std::max(heights.second, *high)};
      }
    }
  }
  return heights;
}

bool is_barrel(const ProblemStatement& design) { return design.mechanism->form == Form::EndRoller; }

/// A barrel with its groove.
CamSolid barrel_solid(const ProblemStatement& design, const SolidSettings& settings,
                      const ExportAccuracy& accuracy) {
  const PlaneCurve pitch = cam_curves(design, "pitch").front();
  const GrooveSize& groove = *settings.groove;
  const double radius = own_size(design, "radius").value(),
               roller = own_size(design, "roller_radius").value();
  const PlaneCurve profile = cam_curves(design, "profile").front();
  refuse_faults({profile, outer_flank(design, profile)}, design);  // at the mean radius
  const double outside = groove.blank_radius.value_or(radius + groove.depth / 2);
  const BarrelSize size{roller, outside - groove.depth, outside};
  auto [lower, upper] = barrel_flanks(pitch, size, accuracy.tolerance * accuracy.unit.mm);
  CamSolid result;
  for (const ExportedFlank* flank : {&lower, &upper}) {
    const std::size_t patches = flank->surface.angles() * flank->surface.distances();
    result.flanks.push_back({flank->name, patches, flank->worst, flank->proved});
  }
  const double low = heights_of(lower.surface).first, high = heights_of(upper.surface).second;
  if (settings.width <= high - low) {
    throw std::invalid_argument(fmt::format(
        "--width: the groove takes {:.6g} mm along the axis, which a barrel of {:.6g} mm in length "
        "does not hold",
        high - low, settings.width));
  }
  Prism& body = result.solid.body;
  body.from = std::midpoint(low, high) - settings.width / 2;
  body.to = body.from + settings.width;
  body.loops.push_back({DrawnArc{{0, 0}, outside, 0, 180}, DrawnArc{{0, 0}, outside, 180, 360}});
  if (const auto bore = bore_of(design, settings.bore_radius, settings.keyway)) {
    const double turn = settings.phase ? shaft_zero_along(profile, *settings.phase) / radius : 0;
    body.loops.push_back(loop_of(
        outline_of(*bore, {std::cos(turn), std::sin(turn)}, size.floor, "the groove's floor")));
  }
  result.solid.groove = {std::move(lower.surface), std::move(upper.surface)};
  return result;
}

}  // namespace

void require_solid(const ProblemStatement& design, const std::string& curve) {
  if (is_barrel(design) && curve == "profile") return;
  const auto found = cam_curves(design, curve);
  if (!found.empty() && found.front().is_closed()) return;
  throw std::invalid_argument(
      fmt::format("a solid is built of disc cams, whose profile is closed, and of barrels whose "
                  "roller moves along their axis; {} has no such {}",
                  design.mechanism->name, curve));
}

CamSolid cam_solid(const ProblemStatement& design, const SolidSettings& settings,
                   const ExportAccuracy& accuracy) {
  require_solid(design, settings.curve);
  if (is_barrel(design)) {
    if (settings.groove) return barrel_solid(design, settings, accuracy);
    throw std::invalid_argument(
        "a solid of an end cam is a barrel with a groove: state its depth, such as --groove "
        "'10 mm'");
  }
  std::vector<PlaneCurve> sides{cam_curves(design, settings.curve).front()};
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
    body.loops.push_back({DrawnArc{{0, 0}, *groove.blank_radius}});
    result.solid.cuts.push_back(
        {{loops[1], loops[0]}, settings.width - groove.depth, settings.width});
  } else {
    body.loops.push_back(loops.front());
  }
  const PlaneCurve& profile = sides.front();
  if (const auto bore = bore_of(design, settings.bore_radius, settings.keyway)) {
    const Vector2d zero = settings.phase ? shaft_zero_axis(profile, *settings.phase)
                                         : profile.at({profile.begin()}).at;
    body.loops.push_back(loop_of(outline_of(*bore, zero, least_distance(profile), "the profile")));
  }
  return result;
}

}  // namespace camlaw::problems
