// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "output/report/scene.h"

// A spherical Geneva on its sphere, in two views with one height: left along the wheel's axis, with
// the middles of the slots, right from the wheel's side along the driver's axis, with the circle of
// the pin. The frame is that of docs/theory.md, "Geneva mechanisms": the driver's axis along x, the
// wheel's along z. The model has angles alone, so that the sphere's radius is ours; not drawn,
// since the model does not have them: the radius of the pin, the width of the slots, the lock. In
// the right view the slots, which change their shape there, are left out.
namespace camlaw::cli {
namespace {

using Kind = BodyMotion::Kind;

/// A cone of half angle pi / n about the driver's axis carries the pin.
struct Sphere {
  static constexpr double kRadius = 100, kMark = 2.5;  // of the scene: the sphere may have any size
  static constexpr double kEntry = -90;  ///< deg, the driver's angle where the cycle begins
  int slots;
  double half = std::numbers::pi / slots;
  double reach = kRadius * std::cos(half);  ///< of the pin's circle along the driver's axis
  double crank = kRadius * std::sin(half);
};

void draw_wheel(Scene& scene, const Sphere& sphere) {
  scene.body("wheel, seen along its axis", {{Kind::Turn, 1, {0, 0}, "wheel_angle"}});
  scene.circle("pitch", {0, 0}, Sphere::kRadius);
  for (int k = 0; k < sphere.slots; ++k) {
    const double angle = (2 * k - 1) * sphere.half, c = std::cos(angle), s = std::sin(angle);
    scene.segment("arm", {sphere.reach * c, sphere.reach * s},
                  {Sphere::kRadius * c, Sphere::kRadius * s});
  }
  scene.circle("pivot", {0, 0}, Sphere::kMark);
}

void draw_driver_edge(Scene& scene, const Sphere& sphere) {
  scene.body("circle of the pin, seen from its edge");
  scene.segment("way", {sphere.reach, -sphere.crank}, {sphere.reach, sphere.crank});
  scene.body("pin, seen along the wheel's axis",
             {{Kind::Harmonic, 1, {0, sphere.crank}, "", Sphere::kEntry}});
  scene.circle("pin", {sphere.reach, -sphere.crank}, Sphere::kMark);
}

void draw_driver(Scene& scene, const Sphere& sphere, DrawnPoint centre) {
  const DrawnPoint pin{centre.x, centre.y - sphere.crank};
  scene.body("sphere and rim of the wheel, seen along the driver's axis");
  scene.circle("pitch", centre, Sphere::kRadius);
  scene.segment("way", {centre.x, centre.y - Sphere::kRadius},
                {centre.x, centre.y + Sphere::kRadius});
  scene.circle("pitch", centre, sphere.crank);
  scene.body("driver, seen along its axis", {{Kind::Turn, 1, centre}});
  scene.segment("arm", centre, pin);
  scene.circle("pin", pin, Sphere::kMark);
  scene.body("axis of the driver");
  scene.circle("pivot", centre, Sphere::kMark);
  scene.body("direction of rotation of the driver");
  scene.turn_arrow(centre, 1.08 * Sphere::kRadius, 1, 200);
}

}  // namespace

std::optional<Scene> spherical_geneva_scene(const problems::ProblemStatement& design, int points) {
  if (design.mechanism->form != problems::Form::SphericalGeneva) return {};
  const Sphere sphere{static_cast<int>(problems::constant_of(design, "slots"))};
  const DrawnPoint centre{2.3 * Sphere::kRadius, 0};
  Scene scene(fmt::format("{}: slots and pin on a sphere, along the wheel's axis and the driver's",
                          design.mechanism->title));
  scene.drawn_at("wheel_angle", SceneCurves(design, points).values("wheel_angle").front());
  draw_wheel(scene, sphere);
  draw_driver_edge(scene, sphere);
  draw_driver(scene, sphere, centre);
  scene.include({0, 0}, Sphere::kRadius + Sphere::kMark);
  scene.include(centre, Sphere::kRadius + Sphere::kMark);
  return scene;
}

}  // namespace camlaw::cli
