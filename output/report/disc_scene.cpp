// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/export/follower_places.h"
#include "output/report/scene.h"

// Disc cams: profile and pitch curve turn about the origin, the follower stands on them. Places
// come from the model's own curves; the frame's axes are those of docs/theory.md, "Cams".
namespace camlaw::cli {
namespace {

using problems::Form;
using problems::ProblemStatement;
using Kind = BodyMotion::Kind;

/// Of followers that move along y.
const BodyMotion kLift{Kind::Slide, 1, {0, 1}, "displacement"};

/// What is drawn, with what is known of it.
struct Disc {
  const ProblemStatement& design;
  const SceneCurves& curves;
  double zero, lowest, highest;  ///< displacement at the drawn pose; its range
  double size;                   ///< greatest radius of the cam

  double operator[](const char* parameter) const {
    return problems::constant_of(design, parameter);
  }
  /// Where the follower's point is at the drawn pose: the cam has not turned yet.
  DrawnPoint follower() const { return curves.points("pitch").front(); }
};

/// p turned about a pivot by an angle in degrees.
DrawnPoint turned(DrawnPoint p, DrawnPoint pivot, double degrees) {
  const double a = degrees * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
  const DrawnPoint d{p.x - pivot.x, p.y - pivot.y};
  return {pivot.x + d.x * c - d.y * s, pivot.y + d.x * s + d.y * c};
}

void draw_cam(Scene& scene, const Disc& disc, double turning) {
  scene.body("cam", {{Kind::Turn, turning}});
  if (disc.curves.has("second_profile_x")) {
    scene.polyline("cam second", disc.curves.points("second_profile"), true);
  }
  scene.polyline("cam", disc.curves.points("profile"), true);
  if (disc.curves.has("pitch_x")) scene.polyline("pitch", disc.curves.points("pitch"), true);
  if (has_parameter(disc.design, "bore_radius")) {
    scene.circle("bore", {0, 0}, disc["bore_radius"]);
  }
  scene.segment("mark", {0, 0}, disc.curves.points("profile").front());
  scene.include({0, 0}, disc.size);
  if (has_parameter(disc.design, "base_radius")) {
    scene.body("base circle");
    scene.circle("base", {0, 0}, disc["base_radius"]);
  }
  scene.body("direction of rotation");
  scene.turn_arrow({0, 0}, 1.08 * disc.size, turning, turning > 0 ? 200 : 240);
}

/// The straight way of a follower's point, at its x, up and down its stroke.
void draw_way(Scene& scene, DrawnPoint point, const Disc& disc) {
  scene.body("path of the follower");
  const double low = point.y - disc.zero + disc.lowest, high = point.y - disc.zero + disc.highest;
  scene.segment("way", {point.x, low}, {point.x, high});
  scene.include({point.x, low}), scene.include({point.x, high});
}

void draw_roller(Scene& scene, const Disc& disc, DrawnPoint centre) {
  const double radius = disc["roller_radius"], rise = disc.highest - disc.zero;
  draw_way(scene, centre, disc);
  draw_pushed_roller(scene, centre, radius, "displacement");
  scene.include({centre.x, centre.y + rise}, 2.4 * radius);
}

void draw_sliding_roller(Scene& scene, const Disc& disc) {
  draw_roller(scene, disc, disc.follower());
}

void draw_knife_edge(Scene& scene, const Disc& disc) {
  const DrawnPoint tip = disc.follower();
  const double length = 0.3 * disc.size, half = 0.06 * disc.size;
  draw_way(scene, tip, disc);
  scene.body("knife edge", {kLift});
  scene.polyline("roller",
                 {tip, {tip.x - half, tip.y + 2 * half}, {tip.x + half, tip.y + 2 * half}}, true);
  scene.segment("stem", {tip.x, tip.y + 2 * half}, {tip.x, tip.y + length});
  scene.include({tip.x, tip.y + length + disc.highest - disc.zero}, half);
}

DrawnPoint point(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

void draw_flat(Scene& scene, const Disc& disc) {
  const double face = problems::sliding_face(disc.design, disc.zero).foot.y();
  const std::vector<double>& offsets = disc.curves.values("contact_offset");
  const auto [left, right] = std::minmax_element(offsets.begin(), offsets.end());
  draw_way(scene, {0, face}, disc);
  scene.body("flat face, as long as the contact needs it", {kLift});
  scene.segment("face", {*left, face}, {*right, face});
  scene.segment("stem", {0, face}, {0, face + 0.4 * disc.size});
  scene.include({*left, face + disc.highest - disc.zero + 0.4 * disc.size});
  scene.include({*right, face});
}

void draw_conjugate(Scene& scene, const Disc& disc) {
  const problems::RollerPair pair = problems::conjugate_rollers(disc.design, disc.zero);
  const DrawnPoint upper = point(pair.main), lower = point(pair.second);
  const double radius = disc["roller_radius"];
  draw_way(scene, upper, disc);
  scene.body("carriage with two rollers", {kLift});
  scene.segment("stem", lower, upper);
  for (const DrawnPoint& centre : {upper, lower}) {
    scene.roller(centre, radius);
    scene.include({centre.x, centre.y + disc.highest - disc.zero}, 1.2 * radius);
    scene.include({centre.x, centre.y + disc.lowest - disc.zero}, 1.2 * radius);
  }
}

void draw_arm(Scene& scene, const Disc& disc) {
  const DrawnPoint pivot{disc["pivot_distance"], 0}, centre = disc.follower();
  const double radius = disc["roller_radius"];
  draw_roller_arm(scene, pivot, centre, radius);
  for (const double at : {disc.lowest, disc.highest}) {
    scene.include(turned(centre, pivot, disc.zero - at), radius);
  }
  scene.include(pivot, 0.5 * radius);
}

void draw_flat_arm(Scene& scene, const Disc& disc) {
  const DrawnPoint pivot{disc["pivot_distance"], 0};
  const problems::FaceLine face = problems::swinging_face(disc.design, disc.zero);
  const std::vector<double>& levers = disc.curves.values("contact_lever");
  const auto [least, most] = std::minmax_element(levers.begin(), levers.end());
  const DrawnPoint foot = point(face.foot);
  const auto along = [&](double t) { return point(face.foot + t * face.along); };
  scene.body("arm with its face, as long as the contact needs it",
             {{Kind::Turn, -1, pivot, "displacement"}});
  scene.segment("arm", pivot, foot);
  scene.segment("arm", foot, along(*least));
  scene.segment("face", along(*least), along(*most));
  scene.body("pivot");
  scene.circle("pivot", pivot, 0.04 * pivot.x);
  for (const double at : {disc.lowest, disc.highest}) {
    scene.include(turned(along(*most), pivot, disc.zero - at));
  }
  scene.include(pivot, 0.05 * pivot.x);
}

using DrawFollower = void (*)(Scene&, const Disc&);

/// What draws the follower of a disc cam; null for other machines.
DrawFollower drawn_follower(Form form) {
  switch (form) {
    case Form::DiscRoller:
      return draw_sliding_roller;
    case Form::DiscKnifeEdge:
      return draw_knife_edge;
    case Form::DiscFlat:
      return draw_flat;
    case Form::DiscConjugate:
      return draw_conjugate;
    case Form::DiscFlatArm:
      return draw_flat_arm;
    case Form::DiscTrailingRoller:
    case Form::DiscLeadingRoller:
      return draw_arm;
    default:
      return nullptr;
  }
}

}  // namespace

std::optional<Scene> disc_scene(const ProblemStatement& design, int points) {
  const Form form = design.mechanism->form;
  const auto follower = drawn_follower(form);
  if (follower == nullptr) return {};
  const SceneCurves curves(design, points);
  const std::vector<double>& displacement = curves.values("displacement");
  const auto [lowest, highest] = std::minmax_element(displacement.begin(), displacement.end());
  double size = 0;
  for (const char* curve : {"profile", "second_profile", "pitch"}) {
    if (!curves.has(std::string(curve) + "_x")) continue;
    for (const DrawnPoint& p : curves.points(curve)) size = std::max(size, std::hypot(p.x, p.y));
  }
  if (!std::isfinite(size) || !(size > 0)) return {};
  const Disc disc{design, curves, displacement.front(), *lowest, *highest, size};
  Scene scene(fmt::format("{}, drawn to scale", design.mechanism->title));
  scene.drawn_at("displacement", disc.zero);
  draw_cam(scene, disc, form == Form::DiscLeadingRoller ? -1 : 1);
  follower(scene, disc);
  return scene;
}

}  // namespace camlaw::cli
