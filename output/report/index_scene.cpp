// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "output/report/index_turret.h"

// Index drives, seen along the turret's axis: of a parallel drive the flanks of its cams with the
// sectors that bear them, of the others (rib_scene.cpp) the cam from the side and developed; and
// the turret with its rollers. What the model does not have, the shape of a disc between its
// flanks, is not drawn. The frame is that of docs/theory.md, "Index drives": the cam turns about
// the y axis, which is upwards, so that its side before the picture's plane goes to the right.
namespace camlaw::cli {
namespace {

using problems::ProblemStatement;
using Kind = BodyMotion::Kind;

/// The first cam is told from the others.
const char* tone(int plate) { return plate == 0 ? "cam" : "cam second"; }

/// A flank's curve in its parts, one for each step of the cycle, each with the sector of the cam
/// that bears it; the first one is of the cam of this number.
void draw_flank(Scene& scene, const SceneCurves& curves, const std::string& flank,
                const std::string& angle, const Turret& turret, int cam) {
  const std::vector<DrawnPoint> points = curves.points(flank);
  const std::vector<double>& psi = curves.values(angle);
  std::vector<DrawnPoint> sector{{0, 0}};
  const auto draw = [&] {
    scene.polyline(tone(cam % turret.plates), sector, true);
    sector.resize(1);
    ++cam;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && psi[i] < psi[i - 1] - 0.5 * turret.step()) draw();  // a hand-over
    sector.push_back(points[i]);
    scene.include({0, 0}, std::hypot(points[i].x, points[i].y));
  }
  draw();
}

/// The disc cams of a parallel drive, which turn in the plane of the picture.
void draw_discs(Scene& scene, const ProblemStatement& design, const SceneCurves& curves,
                const Turret& turret) {
  scene.body("cams: the flanks that drive and those that hold", {{Kind::Turn, 1}});
  draw_flank(scene, curves, "flank", "roller_angle", turret, 0);
  draw_flank(scene, curves, "second_flank", "second_roller_angle", turret, turret.plates - 1);
  scene.circle("bore", {0, 0}, problems::constant_of(design, "bore_radius"));
  scene.segment("mark", {0, 0}, curves.points("flank").front());
  scene.body("direction of rotation");
  scene.turn_arrow({0, 0}, 2.5 * problems::constant_of(design, "bore_radius"), 1, 200);
}

/// The side of a radial roller.
std::vector<DrawnPoint> roller_from_side(const Turret& turret, double psi, double length) {
  const DrawnPoint middle = turret.at(psi);
  const double angle = psi * std::numbers::pi / 180, half = 0.5 * length, r = turret.roller;
  const DrawnPoint out{-std::cos(angle), std::sin(angle)}, side{out.y, -out.x};
  const auto corner = [&](double along, double across) {
    return DrawnPoint{middle.x + along * out.x + across * side.x,
                      middle.y + along * out.y + across * side.y};
  };
  return {corner(-half, -r), corner(half, -r), corner(half, r), corner(-half, r)};
}

}  // namespace

void draw_turret_rollers(Scene& scene, const Turret& turret, double first, double radial_length) {
  for (int k = 0; k < turret.rollers * turret.plates; ++k) {
    const double psi = first - k * turret.step();
    const DrawnPoint middle = turret.at(psi);
    if (radial_length == 0) {
      scene.roller(middle, turret.roller);
      continue;
    }
    scene.polyline("roller", roller_from_side(turret, psi, radial_length), true);
    Turret stem = turret;
    stem.radius -= 0.5 * radial_length;
    scene.segment("arm", turret.centre, stem.at(psi));
  }
}

void draw_hidden_rollers(Scene& scene, const Turret& turret, double first, double length) {
  for (int k = 0; k < turret.rollers; ++k) {
    scene.polyline("hidden", roller_from_side(turret, first - k * turret.step(), length), true);
  }
}

std::optional<Scene> index_scene(const ProblemStatement& design, int points) {
  using problems::Form;
  const Form form = design.mechanism->form;
  const bool discs = form == Form::ParallelIndex, radial = form == Form::RollerGear;
  if (!discs && !radial && form != Form::BarrelIndex) return {};
  const auto constant = [&](const char* name) { return problems::constant_of(design, name); };
  const SceneCurves curves(design, points);
  const Turret turret{{constant("axis_distance"), 0},
                      constant("turret_radius"),
                      constant("roller_radius"),
                      static_cast<int>(constant("rollers")),
                      discs ? static_cast<int>(constant("plates")) : 1};
  const double turned = curves.values("displacement").front();
  if (!std::isfinite(turned) || !std::isfinite(curves.values("pressure_angle").front())) return {};
  Scene scene(fmt::format("{}, drawn to scale", design.mechanism->title));
  scene.drawn_at("displacement", turned);
  const double length = constant("face_width");
  if (discs) {
    draw_discs(scene, design, curves, turret);
    scene.body("turret with its rollers", {{Kind::Turn, -1, turret.centre, "displacement"}});
    scene.circle("pitch", turret.centre, turret.radius);
    draw_turret_rollers(scene, turret, curves.values("roller_angle").front(), 0);
  } else {
    draw_ribs_and_turret(scene, design, curves, turret, points);
  }
  const double reach = turret.radius + (radial ? 0.5 * length : 1.2 * turret.roller);
  scene.body("axis of the turret");
  scene.circle("pivot", turret.centre, discs ? constant("shaft_radius") : 0.1 * turret.radius);
  scene.include(turret.centre, 1.02 * reach);
  return scene;
}

}  // namespace camlaw::cli
