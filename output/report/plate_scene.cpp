// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/cams/cam_shape.h"
#include "machines/model/known_names.h"
#include "output/report/scene.h"

// Cams that are developed, or are plates: the profile travels along x under a roller. And the mark
// on its way that stands for a follower of unknown shape.
namespace camlaw::cli {
namespace {

using problems::Form;
using problems::ProblemStatement;
using Kind = BodyMotion::Kind;

/// A curve three times over, so that it fills the window wherever the cam stands.
std::vector<DrawnPoint> thrice(const std::vector<DrawnPoint>& curve, double period) {
  std::vector<DrawnPoint> whole;
  for (const int turn : {-1, 0, 1}) {
    for (const DrawnPoint& p : curve) whole.push_back({p.x + turn * period, p.y});
  }
  return whole;
}

/// The profile three times over, as a body with a straight back.
std::vector<DrawnPoint> repeated(const std::vector<DrawnPoint>& profile, double period,
                                 double back) {
  std::vector<DrawnPoint> outline = thrice(profile, period);
  outline.insert(outline.begin(), {profile.front().x - period, back});
  outline.push_back({profile.back().x + period, back});
  return outline;
}

}  // namespace

std::optional<Scene> plate_scene(const ProblemStatement& design, int points) {
  const auto shape = problems::cam_shape(*design.mechanism);
  if (shape != problems::CamShape::Drum && shape != problems::CamShape::Plate) return {};
  const SceneCurves curves(design, points);
  const std::vector<DrawnPoint> profile = curves.points("profile"), pitch = curves.points("pitch");
  const double period = pitch.back().x - pitch.front().x;
  const double radius = problems::constant_of(design, "roller_radius");
  double low = profile.front().y, high = pitch.front().y;
  for (const DrawnPoint& p : profile) low = std::min(low, p.y);
  for (const DrawnPoint& p : pitch) high = std::max(high, p.y);
  if (!std::isfinite(low) || !std::isfinite(high) || !(period > 0)) return {};
  const bool arm = design.mechanism->form == Form::EndArm;
  const double back = low - 1.5 * radius, centre = pitch.front().x;
  Scene scene(fmt::format("{}, developed, drawn to scale", design.mechanism->title));
  scene.drawn_at("displacement", curves.values("displacement").front());
  scene.body("cam, developed", {{Kind::Slide, -period / 360, {1, 0}}});
  scene.polyline("cam", repeated(profile, period, back), true);
  scene.polyline("pitch", thrice(pitch, period), false);
  scene.segment("mark", {profile.front().x, back}, profile.front());
  scene.body("direction in which the cam moves");
  scene.straight_arrow({centre + 0.46 * period, back - 0.6 * radius},
                       {centre + 0.34 * period, back - 0.6 * radius});
  if (arm) {
    draw_roller_arm(scene, {0, 0}, pitch.front(), radius);
    scene.include({0, 0}, radius);
  } else {
    draw_pushed_roller(scene, pitch.front(), radius, "displacement");
  }
  scene.include({centre - period / 2, back});
  scene.include({centre + period / 2, high + 2.6 * radius});
  return scene;
}

std::optional<Scene> slider_scene(const ProblemStatement& design, int points) {
  const SceneCurves curves(design, points);
  const std::string moved(problems::known::kDisplacement);
  const auto* const declared = problems::response_called(*design.mechanism, moved);
  if (!curves.has(moved) || (declared != nullptr && declared->unit != "mm")) return {};
  const std::vector<double>& displacement = curves.values(moved);
  const auto [low, high] = std::minmax_element(displacement.begin(), displacement.end());
  const double stroke = *high - *low, zero = displacement.front();
  if (!std::isfinite(stroke) || !(stroke > 0)) return {};
  Scene scene(fmt::format("{}: where its follower is on its path", design.mechanism->title));
  scene.drawn_at(moved, zero);
  const double half = 0.05 * stroke, thick = 0.015 * stroke;
  scene.body("path of the follower");
  scene.segment("way", {*low, 0}, {*high, 0});
  for (const double end : {*low, *high}) scene.segment("way", {end, -half}, {end, half});
  scene.body("follower", {{Kind::Slide, 1, {1, 0}, moved}});
  scene.polyline(
      "roller",
      {{zero - thick, -half}, {zero + thick, -half}, {zero + thick, half}, {zero - thick, half}},
      true);
  scene.include({*low - 2 * thick, -1.5 * half});
  scene.include({*high + 2 * thick, 1.5 * half});
  return scene;
}

}  // namespace camlaw::cli
