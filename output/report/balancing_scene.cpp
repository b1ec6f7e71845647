// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/export/follower_places.h"
#include "output/report/scene.h"

// A balancing cam and its roller, each where the model has it "were the roller always on the cam".
// Of two equal cams one is drawn. Not drawn, since the model has no places or sizes for them: the
// stack of springs (its parts are known, not where it stands), the Geneva, the shaft.
namespace camlaw::cli {

std::optional<Scene> balancing_scene(const problems::ProblemStatement& design, int points) {
  if (design.mechanism->form != problems::Form::BalancingCam) return {};
  const SceneCurves curves(design, points);
  const std::vector<DrawnPoint> profile = curves.points("profile");
  const std::vector<double>& rise = curves.values("roller_displacement");
  const auto [low, high] = std::minmax_element(rise.begin(), rise.end());
  const double base = problems::constant_of(design, "base_radius"),
               radius = problems::constant_of(design, "roller_radius"),
               axis = problems::balancing_roller(design, 0).y();
  if (!std::isfinite(*low) || !std::isfinite(*high)) return {};
  const bool two = problems::constant_of(design, "cams") > 1;
  Scene scene(fmt::format("{}: {} and its roller, drawn to scale", design.mechanism->title,
                          two ? "one of the two equal cams" : "the cam"));
  scene.drawn_at("roller_displacement", rise.front());
  scene.body("cam", {{BodyMotion::Kind::Turn}});
  scene.polyline("cam", profile, true);
  scene.segment("mark", {0, 0}, profile.front());
  scene.body("path of the roller");
  scene.segment("way", {0, axis + *low}, {0, axis + *high});
  draw_pushed_roller(scene, {0, axis + rise.front()}, radius, "roller_displacement");
  scene.body("base circle");
  scene.circle("base", {0, 0}, base);
  scene.body("direction of rotation");
  scene.turn_arrow({0, 0}, 1.08 * (base + *high), 1, 200);
  scene.include({0, 0}, base + *high);
  scene.include({0, axis + *high}, 2.4 * radius);
  return scene;
}

}  // namespace camlaw::cli
