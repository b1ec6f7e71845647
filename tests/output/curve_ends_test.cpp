// SPDX-License-Identifier: MIT
// Whether an exported curve is closed, and where it turns back over a jump: told by the machine,
// and by the geometry of a corner.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "machines/registry.h"
#include "output/export/tool_path.h"

namespace camlaw::problems::curve_ends_test {
namespace {

using Catch::Contains;
using Eigen::Vector2d;

ProblemStatement cam(const std::string& machine, const std::string& constants = "",
                     const std::string& program = "") {
  const std::string usual =
      "[program]\nsegments = [{name = 'rise', angle = 120, law = 'poly-3-4-5'}, "
      "{name = 'back', law = 'poly-3-4-5'}]\n";
  return read_problem(fmt::format("mechanism = '{}'\n[constants]\n{}\n{}", machine, constants,
                                  program.empty() ? usual : program),
                      "f.toml");
}

PlaneCurve profile_of(const ProblemStatement& statement) {
  return cam_curves(statement, "profile").front();
}

Vector2d advance_of(const PlaneCurve& curve) {
  return curve.at({curve.end(), true}).at - curve.at({curve.begin()}).at;
}

/// A roller of 10 mm on a base circle of 30 mm, lifted by 60 mm at even speed in 60 deg and let
/// down in 200.
const char* const kEvenSpeeds =
    "[program]\nmatched = 'displacement'\nsegments = ["
    "{name = 'rise', angle = 60, law = 'constant-velocity'},"
    "{name = 'back', angle = 200, law = 'constant-velocity'}, {name = 'low'}]\n";
const char* const kSizes = "stroke = 60\nbase_radius = 30\nroller_radius = 10\ncutter_radius = 10";

}  // namespace

TEST_CASE("The curves of a developed cam are open, whatever its size", "[exports]") {
  for (const double radius : {5.0, 20.0, 50.0, 76.0, 77.0, 300.0, 5000.0}) {
    for (const double arm : {20.0, 80.0, 1000.0}) {
      for (const double tilt : {-30.0, 0.0, 25.0}) {
        INFO(radius << " " << arm << " " << tilt);
        const auto statement =
            cam("end-cam-oscillating",
                fmt::format("radius = {}\narm_length = {}\ntilt = {}", radius, arm, tilt));
        for (const PlaneCurve& curve : cam_curves(statement, "all")) {
          CHECK_FALSE(curve.is_closed());
          CHECK(curve.jumps().empty());
          const Vector2d turn(2 * std::numbers::pi * radius, 0);
          CHECK((advance_of(curve) - turn).norm() < 1e-9 * turn.norm());
        }
      }
    }
  }
  CHECK_FALSE(profile_of(cam("end-cam", "radius = 3")).is_closed());
  CHECK_FALSE(profile_of(cam("linear-cam", "travel = 30")).is_closed());
}

TEST_CASE("Every machine with a profile says whether that is closed", "[exports]") {
  int count = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    const bool drawn =
        std::any_of(mechanism.responses.begin(), mechanism.responses.end(),
                    [](const auto& response) { return response.name == "profile_x"; });
    if (!drawn) continue;
    ++count;
    INFO(mechanism.name);
    const bool moved = mechanism.moved_by == MovedBy::Program;
    const auto statement = moved ? cam(mechanism.name)
                                 : read_problem("mechanism = '" + mechanism.name + "'", "f.toml");
    for (const PlaneCurve& curve : cam_curves(statement, "all")) {
      CHECK(curve.is_closed() == (advance_of(curve).norm() < 1e-6));
    }
  }
  CHECK(count >= 12);
}

TEST_CASE("A machine of a file's own has a closed curve where that ends as it began", "[exports]") {
  const auto own = [](const char* way) {
    return read_problem(
        fmt::format("[machine]\nname = 'own'\n[machine.parameters.r]\nunit = 'mm'\ndefault = 40\n"
                    "[responses.profile_x]\nformula = 'r * cos(angle) + {}'\nunit = 'mm'\n"
                    "[responses.profile_y]\nformula = 'r * sin(angle)'\nunit = 'mm'\n",
                    way),
        "own.toml");
  };
  CHECK(profile_of(own("0 * r")).is_closed());
  CHECK(profile_of(own("3 * r")).is_closed());  // also beside the centre
  CHECK_FALSE(profile_of(own("r * angle")).is_closed());
}

TEST_CASE("A profile jumps back at a corner of the pitch curve, and is undercut there",
          "[exports]") {
  const auto statement = cam("disc-cam-roller", kSizes, kEvenSpeeds);
  const PlaneCurve profile = profile_of(statement), pitch = cam_curves(statement, "pitch").front();
  // At 60 deg the roller's centre is 100 mm from the shaft; its path turns by the angle between
  // what runs out by 60 mm in 60 deg and what runs in by 60 mm in 200 deg.
  const double up = 60 / (std::numbers::pi / 3), down = 60 / (std::numbers::pi * 10 / 9);
  const double corner = std::atan(up / 100) + std::atan(down / 100);
  const auto jumps = profile.jumps();
  REQUIRE(jumps.size() == 3);
  CHECK(jumps[0].first == Approx(60));
  CHECK(jumps[0].second == Approx(2 * 10 * std::sin(corner / 2)).epsilon(1e-9));
  CHECK(turns_back(profile) == Approx(60));
  CHECK_FALSE(turns_back(pitch));
  const PlaneCurve cutter = cam_curves(statement, "cutter").front();
  CHECK(cutter.jumps().empty());
  CHECK_THROWS_WITH(ToolPath(statement, cutter, CurveForm::Arcs, {}),
                    Contains("the profile turns back near 60 deg"));
  CHECK_THROWS_WITH(ToolPath(statement, pitch, CurveForm::Arcs, {}), Contains("turns back"));
}

TEST_CASE("A hollow of a roller's radius is cut by a tool as large", "[exports]") {
  // The velocity jumps up where the rise begins, and nowhere else.
  const auto statement =
      cam("disc-cam-roller", kSizes,
          "[program]\nmatched = 'displacement'\nsegments = ["
          "{name = 'run', angle = 40, to = 0.3, law = 'constant-velocity'},"
          "{name = 'out', angle = 80, to = 1, law = 'joining'}, {name = 'high', angle = 30},"
          "{name = 'back', angle = 150, to = 0, law = 'poly-3-4-5'}, {name = 'low'}]\n");
  const PlaneCurve profile = profile_of(statement);
  REQUIRE(profile.jumps().size() == 1);
  CHECK(profile.jumps().front().first == 360);
  CHECK_FALSE(turns_back(profile));
  const PlaneCurve cutter = cam_curves(statement, "cutter").front();
  CHECK(ToolPath(statement, cutter, CurveForm::Arcs, {}).exported().closed);
  CHECK_THROWS_WITH(ToolPath(statement, profile, CurveForm::Arcs, {}),
                    Contains("the profile jumps by"));
}

TEST_CASE("On a drum the next turn begins where the cycle ends", "[exports]") {
  // From the top down and up again: the peak is at the cycle's end.
  const auto statement = cam("end-cam", "stroke = 30\nradius = 50",
                             "[program]\nmatched = 'displacement'\nsegments = ["
                             "{name = 'down', angle = 180, to = 0, law = 'constant-velocity'},"
                             "{name = 'up', to = 1, law = 'constant-velocity'}]\n");
  const PlaneCurve profile = profile_of(statement);
  CHECK_FALSE(profile.is_closed());
  const double corner = 2 * std::atan(30 / (std::numbers::pi * 50));
  const auto jumps = profile.jumps();
  REQUIRE(jumps.size() == 2);
  CHECK(jumps[1].first == 360);
  for (const auto& [angle, way] : jumps) {
    CHECK(way == Approx(2 * 10 * std::sin(corner / 2)).epsilon(1e-9));
  }
  CHECK(turns_back(profile) == Approx(360));
  CHECK(cam_curves(statement, "pitch").front().jumps().empty());
  const auto words = obstacles(profile);
  CHECK_THAT(words.back(), Contains("at 360 deg: its next turn begins there"));
}

TEST_CASE("Notes on a curve are in its unit of length", "[exports]") {
  const PlaneCurve profile = profile_of(cam("disc-cam-roller", kSizes, kEvenSpeeds));
  const auto mm = obstacles(profile), inches = obstacles(profile.in(kInch));
  REQUIRE(mm.size() == inches.size());
  const double jump = profile.jumps().front().second;
  CHECK_THAT(mm[1], Contains(fmt::format("jumps by {:.4g} mm at 60 deg", jump)));
  CHECK_THAT(inches[1], Contains(fmt::format("jumps by {:.4g} in at 60 deg", jump / 25.4)));
  CHECK(profile.in(kInch).jumps().size() == profile.jumps().size());
}

}  // namespace camlaw::problems::curve_ends_test
