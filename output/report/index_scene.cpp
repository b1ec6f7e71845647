// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/report/scene.h"

// Index drives, seen along the turret's axis: of a parallel drive the flanks of its cams with the
// sectors that bear them, of the others the cam from the side, and the turret with its rollers.
// What the model does not have, the shape of a disc between its flanks and the ribs from the side,
// is not drawn.
namespace camlaw::cli {
namespace {

using problems::ProblemStatement;
using Kind = BodyMotion::Kind;

/// The turret, its angles in degrees.
struct Turret {
  Point centre;
  double radius, roller;
  int rollers, plates;  ///< in a ring; rings
  double step() const { return 360.0 / (rollers * plates); }
  Point at(double psi) const {
    const double angle = psi * std::numbers::pi / 180;
    return {centre.x - radius * std::cos(angle), radius * std::sin(angle)};
  }
};

/// The first cam is told from the others.
const char* tone(int plate) { return plate == 0 ? "cam" : "cam second"; }

/// A flank's curve in its parts, one for each step of the cycle, each with the sector of the cam
/// that bears it; the first one is of the cam of this number.
void draw_flank(Scene& scene, const SceneCurves& curves, const std::string& flank,
                const std::string& angle, const Turret& turret, int cam) {
  const std::vector<Point> points = curves.points(flank);
  const std::vector<double>& psi = curves.values(angle);
  std::vector<Point> sector{{0, 0}};
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

/// A cam whose axis lies in the picture, upwards: its outline, the right-hand side given from the
/// lower end to the upper one, without its ribs' flanks.
void draw_across(Scene& scene, std::vector<Point> right, double bore) {
  const double low = right.front().y, high = right.back().y;
  scene.body("cam, seen from the side, to the top of its ribs");
  std::vector<Point> outline = right;
  for (auto p = right.rbegin(); p != right.rend(); ++p) outline.push_back({-p->x, p->y});
  scene.polyline("cam", outline, true);
  for (const double x : {-bore, bore}) scene.segment("bore", {x, low}, {x, high});
  for (const Point& p : outline) scene.include(p);
}

/// How far, in degrees, the drawn cam goes beside the line of centres: a pitch.
double half_of_cam(const Turret& turret) { return std::min(turret.step(), 60.0); }

/// Of a roller gear the outline follows the rollers' inner ends.
std::vector<Point> globoid(const Turret& turret, double length) {
  std::vector<Point> right;
  constexpr int kSteps = 60;
  const Turret inner{turret.centre, turret.radius - 0.5 * length, 0, turret.rollers, 1};
  for (int i = 0; i <= kSteps; ++i) {
    right.push_back(inner.at(half_of_cam(turret) * (2.0 * i / kSteps - 1)));
  }
  return right;
}

/// The turret's rollers: circles about its axis, or radial ones from the side.
void draw_rollers(Scene& scene, const Turret& turret, double first, double radial_length) {
  for (int k = 0; k < turret.rollers * turret.plates; ++k) {
    const double psi = first - k * turret.step();
    const Point middle = turret.at(psi);
    if (radial_length == 0) {
      scene.roller(middle, turret.roller);
      continue;
    }
    const double angle = psi * std::numbers::pi / 180, half = 0.5 * radial_length;
    const Point out{-std::cos(angle), std::sin(angle)}, side{out.y, -out.x};
    const auto corner = [&](double along, double across) {
      return Point{middle.x + along * out.x + across * side.x,
                   middle.y + along * out.y + across * side.y};
    };
    const double r = turret.roller;
    scene.polyline("roller",
                   {corner(-half, -r), corner(half, -r), corner(half, r), corner(-half, r)}, true);
    scene.segment("arm", turret.centre, corner(-half, 0));
  }
}

}  // namespace

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
  } else if (radial) {
    draw_across(scene, globoid(turret, length), constant("bore_radius"));
  } else {
    const double half = turret.radius * std::sin(half_of_cam(turret) * std::numbers::pi / 180);
    const double top = constant("cam_radius") + 0.5 * length;
    draw_across(scene, {{top, -half}, {top, half}}, constant("bore_radius"));
  }
  scene.body("turret with its rollers", {{Kind::Turn, -1, turret.centre, "displacement"}});
  scene.circle("pitch", turret.centre, turret.radius);
  draw_rollers(scene, turret, curves.values("roller_angle").front(), radial ? length : 0);
  const double reach = turret.radius + (radial ? 0.5 * length : 1.2 * turret.roller);
  scene.circle("pivot", turret.centre, discs ? constant("shaft_radius") : 0.1 * turret.radius);
  scene.include(turret.centre, 1.02 * reach);
  return scene;
}

}  // namespace camlaw::cli
