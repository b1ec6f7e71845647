// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "machines/index_drives/rib_edges.h"
#include "output/report/index_turret.h"

// Cams whose ribs run between a turret's rollers, from the side and developed. The edges of their
// grooves are where rollers touch the flanks: of the side at the ribs' top, of the development
// half-way along a roller.
namespace camlaw::cli {
namespace {

using problems::BesideCam;
using problems::ProblemStatement;
using Kind = BodyMotion::Kind;

constexpr double kRadian = 180 / std::numbers::pi;  // deg
/// Places of a turn at which the ribs are drawn, for a picture that has so many points of its
/// curves; a page has one picture, or those of 200 designs in coarser points.
int places_of_turn(int points) {
  constexpr int kLeast = 60, kMost = 240, kShare = 8;
  return std::clamp(points / kShare, kLeast, kMost);
}

/// Without points that lie on a straight line between their neighbours, as in dwells.
std::vector<DrawnPoint> without_straight(const std::vector<DrawnPoint>& line) {
  constexpr double kStraight = 0.01;  // mm, the last digit of a picture
  std::vector<DrawnPoint> kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0 && i + 1 < line.size()) {
      const DrawnPoint from = kept.back(), to = line[i + 1];
      const double x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
      const double off = std::abs(x * (line[i].y - from.y) - y * (line[i].x - from.x));
      if (off < kStraight * length * 0.1) continue;
    }
    kept.push_back(line[i]);
  }
  return kept;
}

/// What the ribs of a drive are drawn from.
struct RibbedCam {
  problems::Form form;
  const ProblemStatement& design;
  Turret turret;
  std::vector<double> gained;  ///< by the turret since the cycle began, deg
  std::vector<double> slope;   ///< per angle of the cam
  double first;                ///< angle of the driving roller where the cycle begins, deg
  double half;                 ///< half the length along its axis that is drawn, mm

  double constant(std::string_view name) const { return problems::constant_of(design, name); }
  bool is_barrel() const { return form == problems::Form::BarrelIndex; }
  double length() const { return constant("face_width"); }
  /// Of a turn that are known.
  double places() const { return static_cast<double>(gained.size() - 1); }
  problems::RibEdges edges(problems::RibHeight height) const {
    return problems::rib_edges(form, height, [&](std::string_view name) { return constant(name); });
  }
  /// A point beside the cam as the picture has it, whose reader looks along the turret's axis.
  SpunPoint seen(const BesideCam& p) const {
    return is_barrel() ? SpunPoint{-p.z, p.y, p.x} : SpunPoint{p.x, p.y, p.z};
  }
  /// Rollers that come to the cam, each by its steps from the one that drives first.
  int most_steps() const {
    return static_cast<int>(std::ceil(std::abs(gained.back()) / turret.step())) + 2;
  }
};

/// How far, in degrees, the drawn cam goes beside the line of centres: a pitch.
double half_of_cam(const Turret& turret) { return std::min(turret.step(), 60.0); }

/// Both edges of a groove, or of a part of one, where one roller runs: in the coordinates that the
/// cam takes along, or developed.
template <class Point>
struct Groove {
  std::vector<Point> driving, holding;
};

/// The grooves of one turn, each without what lies beyond the drawn length; `place` makes a drawn
/// point of one beside the cam and of the cam's angle, deg.
template <class Point, class Place>
std::vector<Groove<Point>> grooves(const RibbedCam& cam, problems::RibHeight height, Place place) {
  const problems::RibEdges edges = cam.edges(height);
  const double reach = 1.5 * half_of_cam(cam.turret);  // beyond, no edge comes to the drawn length
  std::vector<Groove<Point>> all;
  for (int k = -cam.most_steps(); k <= cam.most_steps(); ++k) {
    Groove<Point> part;
    const auto end_part = [&] {
      if (part.driving.size() > 1) all.push_back(part);
      part = {};
    };
    for (std::size_t i = 0; i < cam.gained.size(); ++i) {
      const double psi = cam.first + cam.gained[i] + k * cam.turret.step();
      if (std::abs(psi) > reach) {
        end_part();
        continue;
      }
      const problems::GrooveSides sides = edges(psi, cam.slope[i]);
      if (std::min(std::abs(sides.driving.y), std::abs(sides.holding.y)) > cam.half) {
        end_part();
        continue;
      }
      const double angle = 360.0 * static_cast<double>(i) / cam.places();
      part.driving.push_back(place(sides.driving, angle));
      part.holding.push_back(place(sides.holding, angle));
    }
    end_part();
  }
  return all;
}

/// A point of the picture where the cam stands at an angle, in the cam's own coordinates.
SpunPoint turned_back(const SpunPoint& p, double angle) {
  const double c = std::cos(angle / kRadian), s = std::sin(angle / kRadian);
  return {c * p.right - s * p.near, p.up, s * p.right + c * p.near};
}

/// The right-hand side of the outline, from the lower end to the upper one, to the ribs' top.
std::vector<DrawnPoint> right_side(const RibbedCam& cam) {
  const double length = cam.length();
  if (cam.is_barrel()) {
    const double top = cam.constant("cam_radius") + 0.5 * length;
    return {{top, -cam.half}, {top, cam.half}};
  }
  std::vector<DrawnPoint> right;
  constexpr int kSteps = 60;  // two degrees each: no corner is seen
  const Turret inner{cam.turret.centre, cam.turret.radius - 0.5 * length, 0, cam.turret.rollers, 1};
  for (int i = 0; i <= kSteps; ++i) {
    right.push_back(inner.at(half_of_cam(cam.turret) * (2.0 * i / kSteps - 1)));
  }
  return right;
}

/// The cam from the side, its bore, and the line that stands before the turret at its zero.
void draw_side(Scene& scene, const RibbedCam& cam) {
  const std::vector<DrawnPoint> right = right_side(cam);
  const double low = right.front().y, high = right.back().y;
  scene.body("cam, seen from the side, with the grooves between its ribs");
  std::vector<DrawnPoint> outline = right;
  for (auto p = right.rbegin(); p != right.rend(); ++p) outline.push_back({-p->x, p->y});
  scene.polyline("cam", outline, true);
  const auto at_top = [&](const BesideCam& p, double angle) {
    SpunPoint seen = cam.seen(p);
    seen.up = std::clamp(seen.up, low, high);
    return turned_back(seen, angle);
  };
  for (const auto& groove : grooves<SpunPoint>(cam, problems::RibHeight::Top, at_top)) {
    scene.spun_groove(groove.driving, groove.holding);
  }
  std::vector<SpunPoint> zero;
  for (const DrawnPoint& p : right) {
    zero.push_back(cam.is_barrel() ? SpunPoint{0, p.y, p.x} : SpunPoint{p.x, p.y, 0});
  }
  scene.spun("zero", zero);
  const double bore = cam.constant("bore_radius");
  for (const double x : {-bore, bore}) scene.segment("hidden", {x, low}, {x, high});
  for (const DrawnPoint& p : outline) scene.include(p);
  scene.body("direction of rotation: the near side of the cam moves to the right");
  const double below = low - 0.1 * (high - low), side = right.front().x;
  scene.straight_arrow({-0.8 * side, below}, {-0.3 * side, below});  // beside the turret
}

/// The surface in which the middles of the rollers run, developed: circumference to the right, as
/// the side that faces the turret moves, and what is along the cam upwards.
struct Development {
  const RibbedCam& cam;
  double radius;  ///< on the line of centres, to whose scale circumferences are drawn
  double height;  ///< of its middle in the picture
  double half;    ///< half its length there
  double by_degree() const { return radius / kRadian; }
  double turn() const { return 360 * by_degree(); }
  /// Of a roller gear lengths are those of the circle about the turret's axis.
  DrawnPoint at(const BesideCam& p) const {
    const SpunPoint s = cam.seen(p);
    // Rollers of a barrel have their middles in the plane that touches this surface.
    if (cam.is_barrel()) return {s.right, height + s.up};
    const double beside = cam.turret.centre.x - std::hypot(s.right, s.near);
    return {radius * std::atan2(-s.near, s.right),
            height + cam.turret.radius * std::atan2(s.up, beside)};
  }
  /// Where a roller's middle is at psi, deg.
  DrawnPoint roller(double psi) const {
    if (!cam.is_barrel()) return {0, height + cam.turret.radius * psi / kRadian};
    Turret lowered = cam.turret;
    lowered.centre.y += height;
    return lowered.at(psi);
  }
  double limited(double y) const { return std::clamp(y, height - half, height + half); }
};

Development developed(const RibbedCam& cam, double below) {
  const double radius =
      cam.is_barrel() ? cam.constant("cam_radius") : cam.turret.centre.x - cam.turret.radius;
  const double half =
      cam.is_barrel() ? cam.half : cam.turret.radius * half_of_cam(cam.turret) / kRadian;
  return {cam, radius, -(below + 1.3 * half), half};
}

/// The path of one roller's axis through three turns, in its parts that lie on the cam: psi, deg,
/// is the roller's angle where the middle turn begins, and `gained` what the turret turns by.
void draw_roller_path(Scene& scene, const Development& drum, const std::vector<double>& gained,
                      double psi) {
  const auto places = static_cast<double>(gained.size() - 1);
  std::vector<DrawnPoint> path;
  const auto end_part = [&] {
    if (path.size() > 1) scene.polyline("pitch", without_straight(path), false);
    path.clear();
  };
  for (const int turn : {-1, 0, 1}) {
    for (std::size_t i = 0; i < gained.size(); ++i) {
      const double here = psi + gained[i] - gained.front() + turn * drum.cam.gained.back();
      if (std::abs(here) > half_of_cam(drum.cam.turret)) {
        end_part();
        continue;
      }
      const DrawnPoint roller = drum.roller(here);
      const double share = static_cast<double>(i) / places + turn;
      path.push_back({roller.x - drum.turn() * share, roller.y});
    }
  }
  end_part();
}

/// The grooves of three turns: what lies between their edges, then the edges on the cam.
void draw_grooves(Scene& scene, const Development& drum) {
  const auto at_middle = [&](const BesideCam& p, double angle) {
    const DrawnPoint point = drum.at(p);
    return DrawnPoint{point.x - drum.by_degree() * angle, drum.limited(point.y)};
  };
  for (const auto& groove : grooves<DrawnPoint>(drum.cam, problems::RibHeight::Middle, at_middle)) {
    for (const int turn : {-1, 0, 1}) {
      const auto moved = [&](std::vector<DrawnPoint> edge) {
        for (DrawnPoint& p : edge) p.x -= turn * drum.turn();
        return without_straight(edge);
      };
      const std::vector<DrawnPoint> driving = moved(groove.driving),
                                    holding = moved(groove.holding);
      std::vector<DrawnPoint> between = driving;
      between.insert(between.end(), holding.rbegin(), holding.rend());
      scene.polyline("groove", between, true);
      scene.polyline("edge", driving, false);
      scene.polyline("edge", holding, false);
    }
  }
}

/// The angles of the cam under its development, of three turns; they move with it.
void draw_angles(Scene& scene, const Development& drum, double low) {
  constexpr int kStep = 60, kTurn = 360;
  const double letters = 0.03 * drum.turn(), tick = 0.3 * letters;
  scene.segment("axis", {-1.5 * drum.turn(), low}, {1.5 * drum.turn(), low});
  for (int angle = -kTurn; angle <= 2 * kTurn; angle += kStep) {
    const double x = -drum.by_degree() * angle;
    scene.segment("axis", {x, low}, {x, low - tick});
    scene.text({x, low - tick - 0.7 * letters}, letters,
               fmt::format("{}°", (angle + kTurn) % kTurn));
  }
}

/// The developed cam, which moves as the side that faces the turret does, and the rollers on it.
void draw_developed(Scene& scene, const SceneCurves& curves, const Development& drum) {
  const RibbedCam& cam = drum.cam;
  const double far = 1.5 * drum.turn(), low = drum.height - drum.half,
               high = drum.height + drum.half;
  const double lowest = low - 0.3 * drum.half - cam.turret.roller;  // below rollers that leave it
  scene.body("cam, developed, with the grooves of its rollers",
             {{Kind::Slide, drum.by_degree(), {1, 0}}});
  scene.polyline("cam", {{-far, low}, {far, low}, {far, high}, {-far, high}}, true);
  draw_grooves(scene, drum);
  for (int k = -cam.most_steps(); k <= cam.most_steps(); ++k) {
    draw_roller_path(scene, drum, curves.values("displacement"), cam.first + k * cam.turret.step());
  }
  for (const int turn : {-1, 0, 1}) {
    scene.segment("zero", {turn * drum.turn(), low}, {turn * drum.turn(), high});
  }
  draw_angles(scene, drum, lowest);
  scene.body("where the angle of the cam is read");
  scene.segment("reading", {0, high}, {0, lowest});
  const double drawn = curves.values("roller_angle").front();
  scene.drawn_at("roller_angle", drawn);
  const DrawnPoint about{cam.turret.centre.x, cam.turret.centre.y + drum.height};
  const BodyMotion follow =
      cam.is_barrel()
          ? BodyMotion{Kind::Turn, -1, about, "roller_angle"}
          : BodyMotion{Kind::Slide, cam.turret.radius / kRadian, {0, 1}, "roller_angle"};
  scene.body("roller that drives or holds, and its neighbours", {follow});
  for (const int k : {0, -1, 1}) {
    scene.roller(drum.roller(drawn + k * cam.turret.step()), cam.turret.roller);
  }
  scene.include({-0.5 * drum.turn(), lowest - 0.08 * drum.turn()});
  scene.include({0.5 * drum.turn(), high});
  scene.body("direction in which the developed cam moves");
  const double above = high + 0.15 * drum.half;
  scene.straight_arrow({-0.45 * drum.turn(), above}, {-0.35 * drum.turn(), above});
}

}  // namespace

void draw_ribs_and_turret(Scene& scene, const ProblemStatement& design, const SceneCurves& curves,
                          const Turret& turret, int points) {
  const SceneCurves coarse(design, places_of_turn(points));
  RibbedCam cam{design.mechanism->form,
                design,
                turret,
                coarse.values("displacement"),
                coarse.slopes("displacement"),
                curves.values("roller_angle").front(),
                0};
  const double zero = cam.gained.front();
  for (double& angle : cam.gained) angle -= zero;
  const double root = cam.is_barrel() ? turret.radius : turret.radius - 0.5 * cam.length();
  cam.half = root * std::sin(half_of_cam(turret) / kRadian);
  const auto draw_turret = [&](const char* name) {
    scene.body(name, {{Kind::Turn, -1, turret.centre, "displacement"}});
    scene.circle("pitch", turret.centre, turret.radius);
    draw_turret_rollers(scene, turret, cam.first, cam.is_barrel() ? 0 : cam.length());
  };
  if (!cam.is_barrel()) draw_turret("turret with its rollers");
  draw_side(scene, cam);
  if (cam.is_barrel()) {
    draw_turret("turret with its rollers");
  } else {
    scene.body("rollers behind the cam", {{Kind::Turn, -1, turret.centre, "displacement"}});
    draw_hidden_rollers(scene, turret, cam.first, cam.length());
  }
  const double below = turret.radius + (cam.is_barrel() ? 1.2 * turret.roller : 0.5 * cam.length());
  draw_developed(scene, curves, developed(cam, below));
}

}  // namespace camlaw::cli
