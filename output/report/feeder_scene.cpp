// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/report/scene.h"

// The drive of a signature feeder: the crank about the origin, the guide that rocks about O2 on the
// right, the rack as its pitch line, no longer than it must be to reach the guide, and the pinion's
// pitch circle. The pinion stands on the guide's centre, as docs/theory.md, "Meshing", has it: it
// touches the pitch line where the offset is its radius, and the curves of a drive whose offset is
// another are those that are printed. Not drawn, since the model does not have them: teeth, the
// shape of the guide, the cylinder on the pinion's shaft.
namespace camlaw::cli {
namespace {

using Kind = BodyMotion::Kind;

/// Where the parts of the drive are.
struct Feeder {
  double crank, offset, pinion;
  DrawnPoint guide;  ///< O2, the guide's centre
  const std::vector<double>&length, &angle;

  /// Of the crank pin at sample i of the cycle.
  DrawnPoint pin(std::size_t i) const {
    const double turn =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(length.size() - 1);
    return {crank * std::cos(turn), crank * std::sin(turn)};
  }
  /// Along the rack from the guide to the crank pin. At the cycle's beginning the pin is on the
  /// line of centres.
  DrawnPoint along(std::size_t i) const {
    const double swung = (angle[i] - angle.front()) * std::numbers::pi / 180;
    const double inclined = -std::asin(offset / (guide.x - crank)) - swung;
    return {-std::cos(inclined), std::sin(inclined)};
  }
  /// The point of the pitch line that is `back` away from the crank pin.
  DrawnPoint rack(std::size_t i, double back) const {
    const DrawnPoint from = pin(i), direction = along(i);
    return {from.x - back * direction.x, from.y - back * direction.y};
  }
};

void draw_pinion(Scene& scene, const Feeder& feeder) {
  const DrawnPoint centre = feeder.guide;
  scene.body("pinion, its pitch circle", {{Kind::Turn, 1, centre, "drum_angle"}});
  scene.circle("roller", centre, feeder.pinion);
  scene.segment("mark", centre, {centre.x, centre.y + feeder.pinion});
  scene.include(centre, feeder.pinion);
}

void draw_guide_and_rack(Scene& scene, const Feeder& feeder, double mark) {
  const BodyMotion rocking{Kind::Turn, 1, feeder.guide, "guide_angle"};
  const DrawnPoint pin = feeder.pin(0);
  const double reach = *std::max_element(feeder.length.begin(), feeder.length.end());
  scene.body("guide, from its centre to the rack", {rocking});
  scene.segment("arm", feeder.guide, feeder.rack(0, feeder.length.front()));
  scene.body("rack, its pitch line", {rocking, {Kind::Slide, 1, feeder.along(0), "guide_length"}});
  scene.segment("face", pin, feeder.rack(0, reach));
  scene.circle("joint", pin, mark);
  for (std::size_t i = 0; i < feeder.length.size(); ++i) scene.include(feeder.rack(i, reach));
}

void draw_crank(Scene& scene, const Feeder& feeder, double mark) {
  scene.body("circle of the crank pin");
  scene.circle("pitch", {0, 0}, feeder.crank);
  scene.body("crank", {{Kind::Turn}});
  scene.segment("arm", {0, 0}, feeder.pin(0));
  scene.circle("joint", feeder.pin(0), mark);
  scene.include({0, 0}, feeder.crank + mark);
  scene.body("direction of rotation of the crank");
  scene.turn_arrow({0, 0}, 1.15 * feeder.crank, 1, 150);
}

}  // namespace

std::optional<Scene> feeder_scene(const problems::ProblemStatement& design, int points) {
  if (design.mechanism->form != problems::Form::SignatureFeeder) return {};
  const auto constant = [&](const char* name) { return problems::constant_of(design, name); };
  const SceneCurves curves(design, points);
  const Feeder feeder{constant("crank_radius"),      constant("offset"),
                      constant("pinion_radius"),     {constant("centre_distance"), 0},
                      curves.values("guide_length"), curves.values("guide_angle")};
  if (!std::isfinite(feeder.length.front())) return {};
  Scene scene(fmt::format("{}, drawn to scale", design.mechanism->title));
  for (const char* curve : {"guide_length", "guide_angle", "drum_angle"}) {
    scene.drawn_at(curve, curves.values(curve).front());
  }
  const double mark = 0.06 * feeder.crank;
  draw_pinion(scene, feeder);
  draw_guide_and_rack(scene, feeder, mark);
  draw_crank(scene, feeder, mark);
  scene.body("centres of crank and guide");
  for (const DrawnPoint& centre : {DrawnPoint{0, 0}, feeder.guide})
    scene.circle("pivot", centre, mark);
  return scene;
}

}  // namespace camlaw::cli
