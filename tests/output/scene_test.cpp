// SPDX-License-Identifier: MIT
// Scenes of reports: every body, moved as motion.js moves it, is where the model has it.
#include <catch2/catch.hpp>

#include "tests/output/picture.h"

namespace camlaw::cli::scene_test {
namespace {

using namespace picture;

/// A roller touches the drawn profile all through the cycle.
void check_touches(const Picture& picture, const std::string& follower, const std::string& cam) {
  constexpr double kRounding = 0.03;  // mm, of coordinates and of chords
  for (const int place : kPlaces) {
    INFO(place);
    const Shape roller = picture.shape(follower, "roller", place);
    const Shape profile = picture.shape(cam, "cam", place);
    CHECK(distance_to_path(roller.points[0], profile.points) ==
          Approx(roller.radius).margin(kRounding));
  }
}

TEST_CASE("drawn rollers stay on their cams", "[cli][report]") {
  for (const char* name : {"roller_least_base", "conjugate_least_distance", "leading_least_base",
                           "oscillating_least_peak_angle", "linear_least_travel", "end_rise_share",
                           "oscillating_end_least_radius"}) {
    INFO(name);
    const Picture picture(shipped("cams/" + std::string(name)));
    const std::string mechanism = shipped("cams/" + std::string(name)).mechanism->name;
    const bool arm = mechanism.find("oscillating") != std::string::npos ||
                     mechanism.find("leading") != std::string::npos;
    const bool carriage = mechanism == "disc-cam-conjugate";
    check_touches(picture, arm ? "arm" : carriage ? "carriage" : "roller", "cam");
  }
}

TEST_CASE("of a drawn index drive one roller is driven and one held at every place",
          "[cli][report]") {
  const problems::ProblemStatement design = shipped("index_drives/parallel_eight");
  const Picture picture(design);
  const double radius = problems::constant_of(design, "roller_radius");
  constexpr double kRounding = 0.03;  // mm, of coordinates and of chords
  for (int place = 0; place <= kSamples; place += 5) {
    INFO(place);
    std::vector<Shape> flanks = picture.shapes("cams", "cam", place);
    for (Shape& other : picture.shapes("cams", "cam second", place)) {
      flanks.push_back(std::move(other));
    }
    int touching = 0;
    for (const Shape& flank : flanks) {
      for (const Shape& roller : picture.shapes("turret", "roller", place)) {
        const double gap = distance_to_path(roller.points[0], flank.points) - radius;
        touching += std::abs(gap) < kRounding;
      }
    }
    CHECK(touching >= 2);
  }
}

TEST_CASE("the second roller of a drawn conjugate cam stays on the second cam", "[cli][report]") {
  const Picture picture(shipped("cams/conjugate_least_distance"));
  for (const int place : kPlaces) {
    const Shape lower = picture.shapes("carriage", "roller", place)[1];
    const Shape second = picture.shape("cam", "cam second", place);
    CHECK(distance_to_path(lower.points[0], second.points) == Approx(lower.radius).margin(0.03));
  }
}

TEST_CASE("drawn edges and faces touch their cams and no more", "[cli][report]") {
  const auto least = [](const Shape& face, const Shape& cam) {
    double gap = std::numeric_limits<double>::infinity();
    for (const DrawnPoint& p : cam.points) gap = std::min(gap, distance_to_path(p, face.points));
    return gap;
  };
  const Picture knife(shipped("cams/knife_edge_convex_base"));
  const Picture flat(shipped("cams/flat_least_base"));
  const Picture arm(shipped("cams/oscillating_flat_least_base"));
  constexpr double kRounding = 0.03, kSampled = 0.2;  // mm; the cam's samples are apart
  for (const int place : kPlaces) {
    INFO(place);
    const Shape edge = knife.shape("knife", "roller", place);
    CHECK(distance_to_path(edge.points[0], knife.shape("cam", "cam", place).points) < kRounding);
    const Shape face = flat.shape("flat face", "face", place);
    const Shape cam = flat.shape("cam", "cam", place);
    CHECK(least(face, cam) < kSampled);
    for (const DrawnPoint& p : cam.points) CHECK(p.y < face.points[0].y + kRounding);
    CHECK(least(arm.shape("arm", "face", place), arm.shape("cam", "cam", place)) < kSampled);
  }
}

TEST_CASE("a mark on its way is where the displacement says", "[cli][report]") {
  const Picture picture(shipped("spine_cutter/least_radius"));
  for (const int place : kPlaces) {
    const std::vector<DrawnPoint> mark = picture.shape("follower", "roller", place).points;
    CHECK((mark[0].x + mark[1].x) / 2 == Approx(picture.value("displacement", place)).margin(0.02));
  }
}

TEST_CASE("a servo motor's working point runs along its way, below what the motor gives",
          "[cli][report]") {
  const auto design = shipped("servo_axis/pick_and_place");
  const Picture picture(design);
  const double wide = 100 / problems::constant_of(design, "maximum_speed");
  const double high = 60 / problems::constant_of(design, "maximum_torque");
  for (const int place : kPlaces) {
    INFO(place);
    const DrawnPoint point = picture.shape("working point", "roller", place).points[0];
    CHECK(point.x == Approx(wide * picture.value("motor_speed", place)).margin(1e-3));
    CHECK(point.y == Approx(high * picture.value("motor_torque", place)).margin(1e-3));
    CHECK(distance_to_path(point, picture.shape("path of", "pitch", place).points) < 0.02);
    // The motor's curve, at this speed, is what the machine says.
    const DrawnPoint most{point.x, high * picture.value("available_torque", place)};
    const Shape curve = picture.shape("greatest torque", "cam", place);
    CHECK(distance_to_path(most, curve.points) < 0.02);
  }
}

TEST_CASE("a drawn balancing cam lifts its roller as the model says", "[cli][report]") {
  for (const char* name : {"balancing-cam", "balancing-cam-spherical"}) {
    INFO(name);
    const Picture picture(problems::read_problem(
        "mechanism = '" + std::string(name) + "'\n[constants]\nbase_radius = '50 mm'\n", "test"));
    check_touches(picture, "roller", "cam");
    for (const int place : kPlaces) {
      const DrawnPoint centre = picture.shape("roller", "roller", place).points[0];
      CHECK(centre.x == 0);
      CHECK(centre.y == Approx(75 + picture.value("roller_displacement", place)).margin(1e-3));
    }
  }
}

TEST_CASE("the pin of a drawn Geneva runs in a slot while the wheel moves", "[cli][report]") {
  const Picture picture(shipped("geneva/fastest"));
  int engaged = 0;
  for (int place = 0; place <= kSamples; place += 5) {
    INFO(place);
    const Shape pin = picture.shape("driver", "roller", place);
    double gap = std::numeric_limits<double>::infinity();
    for (const Shape& slot : picture.shapes("wheel", "roller", place)) {
      gap = std::min(gap, distance_to_path(pin.points[0], slot.points) - pin.radius);
    }
    if (picture.value("wheel_velocity", place) == 0) continue;
    ++engaged;
    CHECK(gap == Approx(0).margin(0.1));  // of chords round the slot's end
  }
  CHECK(engaged > 10);
}

TEST_CASE("both views of a drawn spherical Geneva have the pin in one place on its sphere",
          "[cli][report]") {
  constexpr double kRadius = 100, kMiddle = 230;
  for (const int slots : {3, 6, 8}) {
    INFO(slots);
    const Picture picture(problems::read_problem(
        "mechanism = 'geneva-spherical'\n[constants]\nslots = " + std::to_string(slots) + "\n",
        "test"));
    for (int place = 0; place <= kSamples; place += 5) {
      INFO(place);
      const DrawnPoint above = picture.shape("pin, seen", "pin", place).points[0];
      const DrawnPoint beside = picture.shape("driver, seen", "pin", place).points[0];
      CHECK(above.y == Approx(beside.y).margin(2e-3));
      CHECK(std::hypot(above.x, above.y, beside.x - kMiddle) == Approx(kRadius).margin(2e-3));
      if (picture.value("wheel_velocity", place) == 0) continue;
      double gap = kRadius;
      for (const Shape& slot : picture.shapes("wheel", "arm", place)) {
        gap = std::min(gap, distance_to_path(above, slot.points));
      }
      CHECK(gap == Approx(0).margin(2e-3));
    }
  }
}

problems::ProblemStatement feeder(const std::string& offset) {
  return problems::read_problem(
      "mechanism = 'signature-feeder'\n[constants]\noffset = '" + offset + "'\n", "test");
}

TEST_CASE("a drawn feeder's crank, rack and guide meet as the model has them", "[cli][report]") {
  for (const char* offset : {"0 mm", "45 mm", "52 mm"}) {
    INFO(offset);
    const Picture picture(feeder(offset));
    const DrawnPoint centre = picture.shape("centres", "pivot", 0).points[0], o2{702, 0};
    CHECK(distance(centre, {0, 0}) == 0);
    for (const int place : kPlaces) {
      INFO(place);
      const double phi = place * kDegree;
      const Shape rack = picture.shape("rack", "face", place);
      const Shape guide = picture.shape("guide", "arm", place);
      const DrawnPoint pin{92 * std::cos(phi), 92 * std::sin(phi)}, foot = guide.points[1];
      CHECK(distance(picture.shape("crank", "joint", place).points[0], pin) < 2e-3);
      CHECK(distance(picture.shape("rack", "joint", place).points[0], pin) < 2e-3);
      CHECK(distance(rack.points[0], pin) < 2e-3);
      CHECK(distance(guide.points[0], o2) < 2e-3);
      CHECK(distance_to_path(foot, rack.points) < 2e-3);
      CHECK(distance(foot, o2) == Approx(std::stod(offset)).margin(2e-3));
      CHECK(distance(foot, pin) == Approx(picture.value("guide_length", place)).margin(2e-3));
    }
  }
}

TEST_CASE("a drawn feeder's rack rolls on its pinion where they mesh", "[cli][report]") {
  const Picture picture(feeder("45 mm"));
  const DrawnPoint o2{702, 0};
  const auto direction = [&](DrawnPoint to) { return std::atan2(to.y - o2.y, to.x - o2.x); };
  // Where they touch: so far from the rack's pin, and at this angle of the pinion.
  const auto rolled = [&](int place) {
    const DrawnPoint touching = picture.shape("guide", "arm", place).points[1];
    const DrawnPoint mark = picture.shape("pinion", "mark", place).points[1];
    const double angle = std::remainder(direction(touching) - direction(mark) +
                                            picture.value("drum_angle", place) * kDegree,
                                        2 * std::numbers::pi) -
                         picture.value("drum_angle", place) * kDegree;
    return distance(picture.shape("rack", "face", place).points[0], touching) + 45 * angle;
  };
  for (const int place : kPlaces) CHECK(rolled(place) == Approx(rolled(0)).margin(5e-3));
}

}  // namespace
}  // namespace camlaw::cli::scene_test
