// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "machines/geneva/geneva.h"
#include "numerics/formula/plain_values.h"
#include "output/report/scene.h"

// A planar Geneva: the driver with its pin about the origin, the wheel with its slots. What the
// model does not have, the shape between the slots and the lock, is not drawn.
namespace camlaw::cli {
namespace {

using Kind = BodyMotion::Kind;

/// A slot along the direction at `angle` from a centre: open at the tip circle, round at its end.
std::vector<DrawnPoint> slot(DrawnPoint centre, double angle, double tip, double end,
                             double half_width) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto at = [&](double along, double across) {
    return DrawnPoint{centre.x + along * c - across * s, centre.y + along * s + across * c};
  };
  std::vector<DrawnPoint> outline{at(tip, half_width)};
  constexpr int kSteps = 12;  // corners of 15 deg in a slot's round end are not seen
  for (int i = 0; i <= kSteps; ++i) {
    const double turn = std::numbers::pi * (0.5 + static_cast<double>(i) / kSteps);
    outline.push_back(at(end + half_width * std::cos(turn), half_width * std::sin(turn)));
  }
  outline.push_back(at(tip, -half_width));
  return outline;
}

}  // namespace

std::optional<Scene> geneva_scene(const problems::ProblemStatement& design, int) {
  if (design.mechanism->form != problems::Form::Geneva) return {};
  const double slots = problems::constant_of(design, "slots");
  const PlainValues value;
  const PlanarGeneva geneva{slots};
  const double distance = problems::constant_of(design, "centre_distance"),
               crank = distance * value(geneva.crank());
  const double pin = problems::constant_of(design, "pin_radius");
  const double tip = distance * std::cos(std::numbers::pi / slots);
  const double entry =
      -value(geneva.half_engagement());  // the driver's angle where the cycle begins
  const DrawnPoint wheel{distance, 0}, pin_at{crank * std::cos(entry), crank * std::sin(entry)};
  const double wheel_angle = value(geneva.at(entry).angle);
  Scene scene(fmt::format("{}: crank, pin and slots, drawn to scale", design.mechanism->title));
  scene.drawn_at("wheel_angle", wheel_angle * 180 / std::numbers::pi);
  scene.body("wheel", {{Kind::Turn, -1, wheel, "wheel_angle"}});
  scene.circle("pitch", wheel, tip);
  for (int k = 0; k < static_cast<int>(slots); ++k) {
    const double angle = std::numbers::pi - wheel_angle + 2 * std::numbers::pi * k / slots;
    scene.polyline("roller", slot(wheel, angle, tip, distance - crank, pin), false);
  }
  scene.circle("pivot", wheel, 0.05 * tip);
  scene.body("driver", {{Kind::Turn, 1}});
  scene.segment("arm", {0, 0}, pin_at);
  scene.circle("roller", pin_at, pin);
  scene.circle("pivot", {0, 0}, 0.05 * tip);
  scene.body("direction of rotation");
  scene.turn_arrow({0, 0}, crank + 2 * pin, 1, 150);
  scene.include({0, 0}, crank + 1.2 * pin);
  scene.include(wheel, 1.02 * tip);
  return scene;
}

}  // namespace camlaw::cli
