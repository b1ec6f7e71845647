// SPDX-License-Identifier: MIT
// The path that two followers make together: its picture, and that the shipped one keeps clear of
// the wall and the nests.
#include <catch2/catch.hpp>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "tests/output/picture.h"

namespace camlaw::cli::path_scene_test {
namespace {

using namespace picture;

/// The gripper as the two laws place it, mm: lift twice, across once out and back.
struct Gripper {
  double phase, out, right, back;  ///< deg
  Law<double> law = find_law("modified-sine").law();

  /// From 0 to 1 over a stretch of the turn, deg.
  double gone(double angle, double from, double length) const {
    return law(std::clamp((angle - from) / length, 0.0, 1.0)).s;
  }
  DrawnPoint at(double angle) const {
    const double lift =
        gone(angle, 0, 55) - gone(angle, 85, 55) + gone(angle, 180, 55) - gone(angle, 265, 55);
    double across = 0;  // the motion back may go on into the next turn
    for (const double turn : {0.0, 360.0}) {
      across += gone(angle + turn, phase, out) - gone(angle + turn, phase + out + right, back);
    }
    return {60 * across, 30 * lift};
  }
};

}  // namespace

TEST_CASE("a stated path is drawn, and its point runs along it", "[cli][report]") {
  const Picture picture(shipped("shaft/gripper_path"));
  const std::vector<DrawnPoint> path = picture.shape("path", "pitch", 0).points;
  const Gripper gripper{25, 80, 100, 80};
  for (int place = 0; place <= kSamples; place += 7) {
    INFO(place);
    const DrawnPoint here = picture.shape("point", "roller", place).points[0];
    CHECK(distance_to_path(here, path) < 0.02);
    const DrawnPoint there = gripper.at(360.0 * place / kSamples);
    CHECK(distance(here, there) < 0.01);
  }
  CHECK_NOTHROW(picture.shape("direction", "arrow", 0));
}

TEST_CASE("a path needs both of its coordinates, in one unit", "[cli][report]") {
  const problems::ProblemStatement design = shipped("shaft/gripper_path");
  std::string text = design.text;
  const std::string in_mm = "[responses.path_y]\nunit = \"mm\"";
  text.replace(text.find(in_mm), in_mm.size(), "[responses.path_y]\nunit = \"cm\"");
  CHECK(path_scene(design, kSamples));
  CHECK_FALSE(path_scene(problems::read_problem(text, "f.toml"), kSamples));
  CHECK_FALSE(path_scene(shipped("shaft/two_cams"), kSamples));
}

TEST_CASE("the shipped path keeps clear of wall and nests, and its cam needs less torque",
          "[shaft]") {
  const problems::BoundProblem bound(shipped("shaft/gripper_path"));
  const optim::Optimum found = optim::optimise(bound.space(), {.starts = 2});
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  std::map<std::string, double> at;
  for (std::size_t i = 0; i < found.found.x.size(); ++i) {
    at[found.problem.variables[i].name] = found.found.x[i];
  }
  const Gripper gripper{at.at("across.phase"), at.at("across.out_angle"),
                        at.at("across.right_angle"), at.at("across.back_angle")};
  double wall = 1e9, nests = 1e9;
  for (int i = 0; i < 36000; ++i) {
    const DrawnPoint p = gripper.at(0.01 * i);
    wall = std::min(wall, std::max({12 - p.x, p.x - 48, p.y - 20}));
    nests = std::min(nests, std::max({1 - p.x, p.x - 59, p.y - 8}));
  }
  CHECK(wall >= 4 - 1e-4);
  CHECK(nests >= -1e-4);
  CHECK(std::min(wall - 4, nests) < 0.01);             // one of them holds the design
  CHECK(found.found.assessment.objective.value < 14);  // 22 N m at the start
}

}  // namespace camlaw::cli::path_scene_test
