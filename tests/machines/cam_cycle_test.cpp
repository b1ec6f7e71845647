// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "machines/cams/roller_cam.h"
#include "machines/registry.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::cam_cycle_test {
namespace {

using testing::design_of, testing::response_of, testing::TestDesign;
constexpr double kPi = std::numbers::pi;
constexpr int kPoints = 7200;

/// A program that goes up, rests, comes back and rests, as a file has it.
ProblemStatement program_of(const std::string& mechanism, const std::string& constants = "") {
  return read_problem("mechanism = \"" + mechanism + "\"\n[constants]\n" + constants + R"(
[[program.segments]]
name = "rise"
law = "poly-4-5-6-7"
angle = "100 deg"
[[program.segments]]
name = "high"
angle = "50 deg"
[[program.segments]]
name = "return"
law = "modified-sine"
angle = "120 deg"
[[program.segments]]
name = "low"
)",
                      "cam");
}

double number_of(const ProblemStatement& statement, const std::string& name) {
  for (const EvaluatedResponse& r : evaluate(statement)) {
    if (r.name == name) return r.value;
  }
  FAIL("no response " << name);
  return 0;
}

struct Curves {
  explicit Curves(const ProblemStatement& statement) : all(curves_of(statement)) {
    for (const auto& response : all) traces.push_back(response.curve().trace({}));
  }
  double at(const std::string& name, double degrees) const {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].name == name) return traces[i]->at({degrees})[0];
    }
    FAIL("no curve " << name);
    return 0;
  }
  std::vector<optim::Response> all;
  std::vector<std::unique_ptr<optim::Trace>> traces;
};

double degrees(int i) { return 360.0 * i / kPoints; }

const std::vector<const char*> kDiscs{"disc-cam-roller",         "disc-cam-knife-edge",
                                      "disc-cam-flat",           "disc-cam-oscillating-roller",
                                      "disc-cam-leading-roller", "disc-cam-oscillating-flat"};

}  // namespace

TEST_CASE("mass and inertia of a cam are those of its drawn profile", "[cams]") {
  for (const char* name : kDiscs) {
    INFO(name);
    const ProblemStatement statement = program_of(name);
    const Curves curves(statement);
    double area = 0, moment = 0;  // mm^2, mm^4, of the polygon
    for (int i = 0; i < kPoints; ++i) {
      const double x = curves.at("profile_x", degrees(i)), y = curves.at("profile_y", degrees(i));
      const double u = curves.at("profile_x", degrees(i + 1 == kPoints ? 0 : i + 1));
      const double v = curves.at("profile_y", degrees(i + 1 == kPoints ? 0 : i + 1));
      const double cross = x * v - u * y;
      area += cross / 2;
      moment += cross * (x * x + x * u + u * u + y * y + y * v + v * v) / 12;
    }
    const double bore = 10, volume = 15 * (std::abs(area) - kPi * bore * bore);
    CHECK(number_of(statement, "cam_mass") == Approx(volume * 7850e-9).epsilon(1e-5));
    const double polar = 15 * (std::abs(moment) - kPi * std::pow(bore, 4) / 2);
    CHECK(number_of(statement, "cam_inertia") == Approx(polar * 7850e-9 * 1e-2).epsilon(1e-5));
  }
}

TEST_CASE("a plain disc weighs what a cylinder does", "[cams]") {
  const ProblemStatement statement =
      program_of("disc-cam-flat", "stroke = \"0.000001 mm\"\nbore_radius = \"0 mm\"\n");
  CHECK(number_of(statement, "cam_mass") == Approx(7850 * 0.015 * kPi * 0.04 * 0.04).epsilon(1e-6));
}

TEST_CASE("the tool's way lies a tool's radius outside the profile", "[cams]") {
  for (const char* name : {"disc-cam-roller", "disc-cam-knife-edge", "disc-cam-leading-roller",
                           "end-cam", "end-cam-oscillating", "linear-cam"}) {
    INFO(name);
    const ProblemStatement statement = program_of(name, "cutter_radius = \"7 mm\"\n");
    const Curves curves(statement);
    for (const double angle : {31.0, 77.0, 130.0, 210.0, 300.0}) {
      const double x = curves.at("cutter_x", angle), y = curves.at("cutter_y", angle);
      double nearest = 1e9;
      for (int i = 0; i <= kPoints; ++i) {
        nearest = std::min(nearest, std::hypot(curves.at("profile_x", degrees(i)) - x,
                                               curves.at("profile_y", degrees(i)) - y));
      }
      CHECK(nearest == Approx(7).epsilon(1e-4));
    }
  }
}

TEST_CASE("root mean squares are those of a fine sum, and enclosed", "[cams]") {
  const ProblemStatement statement = program_of("disc-cam-roller", "load = \"40 N\"\n");
  const Curves curves(statement);
  double torque = 0, power = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double at = degrees(i) + 180.0 / kPoints;
    torque += std::pow(curves.at("drive_torque", at), 2) / kPoints;
    power += std::pow(curves.at("drive_power", at), 2) / kPoints;
  }
  CHECK(number_of(statement, "torque_rms") == Approx(std::sqrt(torque)).epsilon(1e-6));
  CHECK(number_of(statement, "power_rms") == Approx(std::sqrt(power)).epsilon(1e-6));
  const Mechanism& mechanism = find_mechanism("disc-cam-roller");
  const TestDesign design = design_of(mechanism, "legendre c=-3,1", {"c"}, {"speed", "offset"});
  for (const char* name : {"torque_rms", "power_rms", "cam_mass", "cam_inertia"}) {
    INFO(name);
    const auto f = response_of(mechanism, name, design.binding).function();
    testing::check_derivatives(f, design.x);
    const auto bounds = f.enclose(design.x);
    const double value = f.value(design.x);
    CHECK((bounds.lower <= value && value <= bounds.upper));
    CHECK(bounds.upper - bounds.lower < 1e-8 * value);
  }
}

TEST_CASE("at the speed of contact loss the cam's force just vanishes", "[cams]") {
  for (const char* name : {"disc-cam-roller", "disc-cam-flat", "disc-cam-oscillating-roller"}) {
    INFO(name);
    const double speed = number_of(program_of(name), "contact_loss_speed");
    const auto lowest = [&](double rpm) {
      const Curves curves(program_of(name, "speed = \"" + std::to_string(rpm) + " rpm\"\n"));
      const bool swings = std::string(name).find("oscillating") != std::string::npos;
      double least = 1e9;
      for (int i = 0; i < kPoints; ++i) {
        least =
            std::min(least, curves.at(swings ? "follower_torque" : "follower_force", degrees(i)));
      }
      return least;
    };
    CHECK(lowest(speed) == Approx(0).margin(1e-3));
    CHECK(lowest(0.99 * speed) > 0);
    CHECK(lowest(1.01 * speed) < 0);
  }
}

TEST_CASE("static and dynamic torque add up to the drive's", "[cams]") {
  const Curves curves(program_of("disc-cam-oscillating-roller", "load = \"2 N m\"\n"));
  for (const double angle : {20.0, 66.0, 180.0, 250.0}) {
    CHECK(curves.at("static_torque", angle) + curves.at("dynamic_torque", angle) ==
          Approx(curves.at("drive_torque", angle)).epsilon(1e-12));
  }
}

TEST_CASE("the cam's work is the friction of the guide", "[cams]") {
  const std::vector<std::pair<const char*, const char*>> cases{{"disc-cam-roller", "0 mm"},
                                                               {"disc-cam-roller", "8 mm"},
                                                               {"disc-cam-roller", "-8 mm"},
                                                               {"disc-cam-knife-edge", "0 mm"},
                                                               {"disc-cam-knife-edge", "8 mm"}};
  for (const auto& [mechanism, offset] : cases) {
    INFO(mechanism << ", " << offset);
    const std::string constants = std::string("guide_friction = 0.12\noffset = \"") + offset +
                                  "\"\nspeed = \"700 rpm\"\nspring_preload = \"300 N\"\n";
    const Curves curves(program_of(mechanism, constants));
    double work = 0, lost = 0;
    for (int i = 0; i < kPoints; ++i) {
      const double at = degrees(i) + 180.0 / kPoints, step = 2 * kPi / kPoints;
      work += curves.at("drive_torque", at) * step;
      // mu N sin alpha (2 a + l_g) / l_g along the follower's path, a - s the overhang left.
      const double side = std::abs(curves.at("contact_force", at) *
                                   std::sin(curves.at("pressure_angle", at) * kPi / 180));
      const double lever = 2 * (40 - curves.at("displacement", at)) / 60 + 1;
      const double velocity = curves.at("velocity", at) / (700 * kPi / 30);
      lost += 0.12 * side * lever * std::abs(velocity) * step;
    }
    CHECK(lost > 0.01);
    CHECK(work == Approx(lost).epsilon(1e-4));
  }
}

TEST_CASE("a bore that leaves nothing is not a design", "[cams]") {
  CHECK(
      std::isnan(number_of(program_of("disc-cam-flat", "bore_radius = \"60 mm\"\n"), "cam_mass")));
}

TEST_CASE("a follower that jams in its guide has no force", "[cams]") {
  const Curves free(program_of("disc-cam-roller", "guide_friction = 0.3\n"));
  CHECK(std::isfinite(free.at("contact_force", 50)));
  const Curves jammed(
      program_of("disc-cam-roller", "guide_friction = 0.9\noverhang = \"120 mm\"\n"));
  CHECK(std::isnan(jammed.at("contact_force", 50)));
  CHECK(std::isnan(jammed.at("drive_torque", 50)));
  CHECK(std::isfinite(jammed.at("contact_force", 20 + 100 + 50 + 120)));
}

TEST_CASE("the spring of a fast cam is the best of a grid", "[cams][problem-files]") {
  const BoundProblem bound = testing::shipped("cams/spring_at_speed.toml");
  const auto optimum = optim::optimise(bound.space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(optimum.found.assessment.global);
  ProblemStatement bare = bound.statement();
  bare.constants[bare.mechanism->parameter("spring_rate")] = 0;
  bare.constants[bare.mechanism->parameter("spring_preload")] = 0;
  const Curves curves(bare);
  std::vector<double> inertia, place;  // N and mm, without a spring
  for (int i = 0; i < kPoints; ++i) {
    inertia.push_back(curves.at("follower_force", degrees(i)));
    place.push_back(curves.at("displacement", degrees(i)));
  }
  // For each rate the least preload that leaves 20 N everywhere, and the greatest force with it.
  const auto greatest = [&](double rate) {
    double preload = 0, most = -1e9;
    for (int i = 0; i < kPoints; ++i) {
      preload = std::max(preload, 20 - inertia[i] - rate * place[i]);
    }
    for (int i = 0; i < kPoints; ++i) {
      most = std::max(most, inertia[i] + rate * place[i] + preload);
    }
    return most;
  };
  CHECK(optimum.found.assessment.objective.value ==
        Approx(testing::grid_minimum(greatest, 0, 60, 240)).epsilon(1e-4));
}

}  // namespace camlaw::problems::cam_cycle_test
