// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "output/report/scene.h"

// The working point of a servo motor in the plane of speed and torque: speed to the right, torque
// upwards, and what the motor gives in all four quadrants. Of a drive without geometry this is what
// there is to see.
namespace camlaw::cli {
namespace {

using Kind = BodyMotion::Kind;

/// From rpm and N m to the picture.
struct SpeedTorque {
  double by_speed, by_torque;
  DrawnPoint at(double speed, double torque) const {
    return {by_speed * speed, by_torque * torque};
  }
};

}  // namespace

std::optional<Scene> servo_scene(const problems::ProblemStatement& design, int points) {
  const SceneCurves curves(design, points);
  for (const char* curve : {"motor_speed", "motor_torque", "available_torque"}) {
    if (!curves.has(curve)) return {};
  }
  for (const char* parameter :
       {"maximum_torque", "corner_speed", "maximum_speed", "end_torque", "continuous_torque"}) {
    if (!has_parameter(design, parameter)) return {};
  }
  const auto constant = [&](const char* name) { return problems::constant_of(design, name); };
  const double most = constant("maximum_torque"), end = constant("end_torque");
  const double corner = constant("corner_speed"), fastest = constant("maximum_speed");
  const std::vector<double>&speed = curves.values("motor_speed"),
        &torque = curves.values("motor_torque");
  if (!std::isfinite(speed.front()) || !std::isfinite(torque.front())) return {};
  constexpr double kWide = 100, kHigh = 60;  // of the scene, to which speed and torque are scaled
  const SpeedTorque plane{kWide / fastest, kHigh / most};
  Scene scene(
      fmt::format("{}: torque of the motor (upwards, to {:.4g} N m) by its speed (to the "
                  "right, to {:.4g} rpm)",
                  design.mechanism->title, most, fastest));
  scene.drawn_at("motor_speed", speed.front());
  scene.drawn_at("motor_torque", torque.front());
  scene.body("greatest torque that the motor gives at its speed");
  scene.polyline("cam",
                 {plane.at(corner, most), plane.at(fastest, end), plane.at(fastest, -end),
                  plane.at(corner, -most), plane.at(-corner, -most), plane.at(-fastest, -end),
                  plane.at(-fastest, end), plane.at(-corner, most)},
                 true);
  scene.body("axes: no torque, no speed");
  scene.segment("mark", plane.at(-fastest, 0), plane.at(fastest, 0));
  scene.segment("mark", plane.at(0, -most), plane.at(0, most));
  scene.body("continuous torque");
  for (const double side : {1.0, -1.0}) {
    const double level = side * constant("continuous_torque");
    scene.segment("way", plane.at(-fastest, level), plane.at(fastest, level));
  }
  scene.body("path of the working point through the cycle");
  std::vector<DrawnPoint> path;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    path.push_back(plane.at(speed[i], torque[i]));
    scene.include(path.back());
  }
  scene.polyline("pitch", path, true);
  scene.body("working point", {{Kind::Slide, plane.by_speed, {1, 0}, "motor_speed"},
                               {Kind::Slide, plane.by_torque, {0, 1}, "motor_torque"}});
  scene.circle("roller", path.front(), 2);
  scene.include(plane.at(-fastest, -most));
  scene.include(plane.at(fastest, most));
  return scene;
}

}  // namespace camlaw::cli
