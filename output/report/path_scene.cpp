// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "numerics/text/dimension.h"
#include "output/report/scene.h"

// The path that two followers make together: a file's own responses path_x and path_y, in one unit
// of length, with the point that runs along it.
namespace camlaw::cli {
namespace {

using Kind = BodyMotion::Kind;

/// The unit of a response of the design; empty where it has none of that name.
std::string unit_of_curve(const problems::ProblemStatement& design, std::string_view name) {
  const auto& all = design.mechanism->responses;
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const auto& r) { return r.name == name && r.curve != nullptr; });
  return found == all.end() ? "" : found->unit;
}

/// Where the path is left fastest: the first of the two samples.
std::size_t fastest_step(const std::vector<DrawnPoint>& path) {
  std::size_t fastest = 0;
  double most = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double way = std::hypot(path[i + 1].x - path[i].x, path[i + 1].y - path[i].y);
    if (way > most) most = way, fastest = i;
  }
  return fastest;
}

}  // namespace

std::optional<Scene> path_scene(const problems::ProblemStatement& design, int points) {
  const std::string unit = unit_of_curve(design, "path_x");
  if (unit.empty() || unit_of_curve(design, "path_y") != unit) return {};
  if (!(si_unit(unit).dimension == si_unit("mm").dimension)) return {};
  const std::vector<DrawnPoint> path = SceneCurves(design, points).points("path");
  const auto is_finite = [](const DrawnPoint& p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
  };
  if (path.size() < 2 || !std::all_of(path.begin(), path.end(), is_finite)) return {};
  DrawnPoint low = path.front(), high = low;
  for (const DrawnPoint& p : path) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double size = std::max(high.x - low.x, high.y - low.y);
  if (!(size > 0)) return {};
  Scene scene("path of path_x (to the right) and path_y (upwards), to one scale, in " + unit);
  scene.drawn_at("path_x", path.front().x);
  scene.drawn_at("path_y", path.front().y);
  scene.include({low.x - 0.05 * size, low.y - 0.05 * size});
  scene.include({high.x + 0.05 * size, high.y + 0.05 * size});
  scene.body("path through the cycle");
  scene.polyline("pitch", path, true);
  const std::size_t at = fastest_step(path);
  const DrawnPoint from = path[at], to = path[at + 1];
  const double way = std::hypot(to.x - from.x, to.y - from.y), arrow = 0.1 * size / way;
  scene.body("direction of motion");
  scene.straight_arrow(from, {from.x + arrow * (to.x - from.x), from.y + arrow * (to.y - from.y)});
  scene.body("point on the path",
             {{Kind::Slide, 1, {1, 0}, "path_x"}, {Kind::Slide, 1, {0, 1}, "path_y"}});
  scene.circle("roller", path.front(), 0.02 * size);
  return scene;
}

}  // namespace camlaw::cli
