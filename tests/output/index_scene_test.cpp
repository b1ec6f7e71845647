// SPDX-License-Identifier: MIT
// Scenes of drives that index: their arrows agree with the motion that is shown, and a barrel's
// roller runs on the path that is drawn of it.
#include <catch2/catch.hpp>

#include "tests/output/picture.h"

namespace camlaw::cli::index_scene_test {
namespace {

using namespace picture;

/// The developed barrel's edge, which moves with it.
double edge_of_barrel(const Picture& picture, int place) {
  return picture.shape("cam, developed", "cam", place).points[0].x;
}

DrawnPoint barrel_roller(const Picture& picture, int place) {
  return picture.shape("roller that drives", "roller", place).points[0];
}

}  // namespace

TEST_CASE("the roller of a drawn barrel runs on its path on the developed drum", "[cli][report]") {
  const Picture picture(shipped("index_drives/barrel_eight"));
  for (int place = 0; place <= kSamples; place += 5) {
    INFO(place);
    double gap = std::numeric_limits<double>::infinity();
    for (const Shape& path : picture.shapes("cam, developed", "pitch", place)) {
      gap = std::min(gap, distance_to_path(barrel_roller(picture, place), path.points));
    }
    CHECK(gap < 0.03);
  }
}

TEST_CASE("a drawn barrel moves as its pressure angle and its arrows say", "[cli][report]") {
  const problems::ProblemStatement design = shipped("index_drives/barrel_eight");
  const Picture picture(design);
  const double radius = problems::constant_of(design, "cam_radius");
  const double place_turn = 2 * std::numbers::pi * radius / kSamples;
  for (int place = 125; place < 175; place += 7) {  // the first half of the index period
    INFO(place);
    const DrawnPoint here = barrel_roller(picture, place), next = barrel_roller(picture, place + 2);
    const double cam = edge_of_barrel(picture, place + 2) - edge_of_barrel(picture, place);
    CHECK(cam == Approx(2 * place_turn));
    // The roller's way over the cam, along its path about the turret's axis and across that: the
    // pressure angle is between them, with its sign (docs/theory.md, (IX11) and (IX16)).
    const double psi = picture.value("roller_angle", place + 1) * kDegree;
    const double x = next.x - here.x - cam, y = next.y - here.y;
    const double along = x * std::sin(psi) + y * std::cos(psi);
    const double across = -x * std::cos(psi) + y * std::sin(psi);
    CHECK(std::atan2(along, across) / kDegree ==
          Approx(picture.value("pressure_angle", place + 1)).margin(0.1));
  }
  for (const char* arrow : {"direction of rotation", "direction in which"}) {
    const std::vector<DrawnPoint> line = picture.shape(arrow, "arrow", 0).points;
    CHECK(line[1].x > line[0].x);
  }
}

TEST_CASE("a spherical Geneva's arrow turns as its driver does", "[cli][report]") {
  const Picture picture(shipped("geneva/fastest_spherical"));
  const DrawnPoint centre = picture.shape("axis of the driver", "pivot", 0).points[0];
  const auto turned = [&](DrawnPoint from, DrawnPoint to) {
    return (from.x - centre.x) * (to.y - centre.y) - (from.y - centre.y) * (to.x - centre.x);
  };
  const std::vector<DrawnPoint> arrow = picture.shape("direction of rotation", "arrow", 0).points;
  const auto pin = [&](int place) {
    return picture.shape("driver, seen along its axis", "pin", place).points[0];
  };
  CHECK(turned(arrow.front(), arrow.back()) > 0);
  CHECK(turned(pin(0), pin(10)) > 0);
}

TEST_CASE("every drawn machine that turns has an arrow", "[cli][report]") {
  for (const char* name :
       {"index_drives/barrel_eight", "index_drives/globoidal_eight", "index_drives/parallel_eight",
        "geneva/fastest", "geneva/fastest_spherical", "balancing_cam/least_stress",
        "signature_feeder/least_acceleration", "cams/conjugate_least_distance",
        "cams/end_rise_share"}) {
    INFO(name);
    const Picture picture(shipped(name));
    CHECK_NOTHROW(picture.shape("direction", "arrow", 0));
  }
  // The near side of a globoidal cam moves as that of a barrel: about the y axis, upwards.
  const Picture globoid(shipped("index_drives/globoidal_eight"));
  const std::vector<DrawnPoint> line = globoid.shape("direction of rotation", "arrow", 0).points;
  CHECK(line[1].x > line[0].x);
}

}  // namespace camlaw::cli::index_scene_test
