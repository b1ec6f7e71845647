// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/report/scene.h"

// Index drives, seen along the turret's axis: of a parallel drive the flanks of its cams with the
// sectors that bear them, of the others the cam from the side, and the turret with its rollers; of
// a barrel below them what the side does not show, the rollers' pitch curves on the developed drum.
// What the model does not have, the shape of a disc between its flanks and the ribs from the side,
// is not drawn. The frame is that of docs/theory.md, "Index drives": the cam turns about the y
// axis, which is upwards, so that its side before the picture's plane goes to the right.
namespace camlaw::cli {
namespace {

using problems::ProblemStatement;
using Kind = BodyMotion::Kind;

/// The turret, its angles in degrees.
struct Turret {
  DrawnPoint centre;
  double radius, roller;
  int rollers, plates;  ///< in a ring; rings
  double step() const { return 360.0 / (rollers * plates); }
  DrawnPoint at(double psi) const {
    const double angle = psi * std::numbers::pi / 180;
    return {centre.x - radius * std::cos(angle), centre.y + radius * std::sin(angle)};
  }
};

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

/// A cam whose axis lies in the picture, upwards: its outline, the right-hand side given from the
/// lower end to the upper one, without its ribs' flanks.
void draw_across(Scene& scene, std::vector<DrawnPoint> right, double bore) {
  const double low = right.front().y, high = right.back().y;
  scene.body("cam, seen from the side, to the top of its ribs");
  std::vector<DrawnPoint> outline = right;
  for (auto p = right.rbegin(); p != right.rend(); ++p) outline.push_back({-p->x, p->y});
  scene.polyline("cam", outline, true);
  for (const double x : {-bore, bore}) scene.segment("bore", {x, low}, {x, high});
  for (const DrawnPoint& p : outline) scene.include(p);
  scene.body("direction of rotation: the near side of the cam moves to the right");
  const double below = low - 0.1 * (high - low), side = right.front().x;
  scene.straight_arrow({-0.8 * side, below}, {-0.3 * side, below});  // beside the turret
}

/// How far, in degrees, the drawn cam goes beside the line of centres: a pitch.
double half_of_cam(const Turret& turret) { return std::min(turret.step(), 60.0); }

/// Of a roller gear the outline follows the rollers' inner ends.
std::vector<DrawnPoint> globoid(const Turret& turret, double length) {
  std::vector<DrawnPoint> right;
  constexpr int kSteps = 60;  // two degrees each: no corner is seen
  const Turret inner{turret.centre, turret.radius - 0.5 * length, 0, turret.rollers, 1};
  for (int i = 0; i <= kSteps; ++i) {
    right.push_back(inner.at(half_of_cam(turret) * (2.0 * i / kSteps - 1)));
  }
  return right;
}

/// A drum of the radius R that is developed: a point of it at the angle phi of the cam is at -R
/// phi.
struct Drum {
  double radius, half;  ///< half its length
  double height;        ///< of its middle in the picture
  double by_degree() const { return radius * std::numbers::pi / 180; }
  double turn() const { return 2 * std::numbers::pi * radius; }
};

/// Where the turret's circle meets the plane that the drum is developed into, below the picture.
Turret lowered(const Turret& turret, const Drum& drum) {
  Turret result = turret;
  result.centre.y -= turret.centre.y - drum.height;
  return result;
}

/// The path of one roller's axis over the drum through three turns, in its parts that lie on it:
/// psi, deg, is the roller's angle where the middle turn begins, `gained` what the turret turns by.
void draw_roller_path(Scene& scene, const Turret& turret, const Drum& drum, double psi,
                      const std::vector<double>& gained) {
  const double reach = std::asin(std::min(drum.half / turret.radius, 1.0)) * 180 / std::numbers::pi;
  const std::size_t steps = gained.size() - 1;
  std::vector<DrawnPoint> path;
  const auto end_part = [&] {
    if (path.size() > 1) scene.polyline("pitch", path, false);
    path.clear();
  };
  for (std::size_t i = 0; i <= 3 * steps; ++i) {
    const std::size_t turn = std::min(i / steps, std::size_t{2}), within = i - turn * steps;
    const double turns = static_cast<double>(turn) - 1;
    const double here = psi + gained[within] + turns * gained.back();
    if (std::abs(here) > reach) {
      end_part();
      continue;
    }
    const double share = static_cast<double>(within) / static_cast<double>(steps) + turns;
    const DrawnPoint roller = turret.at(here);
    path.push_back({roller.x - drum.turn() * share, roller.y});
  }
  end_part();
}

/// The developed drum, which moves as its near side does, and the roller that drives or holds.
void draw_developed(Scene& scene, const SceneCurves& curves, const Turret& above,
                    const Drum& drum) {
  const Turret turret = lowered(above, drum);
  const std::vector<double>& psi = curves.values("roller_angle");
  std::vector<double> gained = curves.values("displacement");
  const double zero = gained.front(), far = 1.5 * drum.turn();
  for (double& angle : gained) angle -= zero;
  scene.body("cam, developed, with the paths of its rollers",
             {{Kind::Slide, drum.by_degree(), {1, 0}}});
  const double low = drum.height - drum.half, high = drum.height + drum.half;
  scene.polyline("cam", {{-far, low}, {far, low}, {far, high}, {-far, high}}, true);
  const int most = static_cast<int>(std::ceil(2 * std::abs(gained.back()) / turret.step())) + 2;
  for (int k = -most; k <= most; ++k) {
    draw_roller_path(scene, turret, drum, psi.front() + k * turret.step(), gained);
  }
  scene.drawn_at("roller_angle", psi.front());
  scene.body("roller that drives or holds", {{Kind::Turn, -1, turret.centre, "roller_angle"}});
  scene.roller(turret.at(psi.front()), turret.roller);
  scene.include({-0.5 * drum.turn(), low}), scene.include({0.5 * drum.turn(), high});
  scene.body("direction in which the developed cam moves");
  const double below = low - 0.2 * drum.half;
  scene.straight_arrow({-0.1 * drum.turn(), below}, {0.1 * drum.turn(), below});
}

/// The turret's rollers: circles about its axis, or radial ones from the side.
void draw_rollers(Scene& scene, const Turret& turret, double first, double radial_length) {
  for (int k = 0; k < turret.rollers * turret.plates; ++k) {
    const double psi = first - k * turret.step();
    const DrawnPoint middle = turret.at(psi);
    if (radial_length == 0) {
      scene.roller(middle, turret.roller);
      continue;
    }
    const double angle = psi * std::numbers::pi / 180, half = 0.5 * radial_length;
    const DrawnPoint out{-std::cos(angle), std::sin(angle)}, side{out.y, -out.x};
    const auto corner = [&](double along, double across) {
      return DrawnPoint{middle.x + along * out.x + across * side.x,
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
    const double below = turret.radius + 1.2 * turret.roller + 1.3 * half;
    draw_developed(scene, curves, turret, {constant("cam_radius"), half, -below});
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
