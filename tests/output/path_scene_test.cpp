// SPDX-License-Identifier: MIT
// The path that two followers make together: its picture, and that the shipped one keeps clear of
// the wall and the nests.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "optim/search/optimise.h"
#include "output/report/design_figure.h"
#include "output/report/problem_sections.h"
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

TEST_CASE("a page has every curve that a body of its picture follows", "[cli][report]") {
  for (const char* name : {"shaft/gripper_path", "servo_axis/pick_and_place", "geneva/fastest",
                           "cams/leading_least_base", "signature_feeder/least_acceleration"}) {
    INFO(name);
    const problems::ProblemStatement design = shipped(name);
    const std::optional<Scene> scene = scene_of(design, 60);
    REQUIRE(scene);
    const Figure figure = design_figure(design, 60);
    for (const std::string& curve : scene->follows()) {
      INFO(curve);
      CHECK(std::any_of(figure.panels.begin(), figure.panels.end(),
                        [&](const Panel& panel) { return panel.y.label == curve; }));
    }
  }
}

TEST_CASE("a page leaves out the coordinates of a profile unless they are limited",
          "[cli][report]") {
  const auto drawn = [](const problems::ProblemStatement& design) {
    std::set<std::string> names;
    for (const Panel& panel : design_figure(design, 60).panels) names.insert(panel.y.label);
    return names;
  };
  const std::string file = "cams/roller_least_base";
  const problems::ProblemStatement design = shipped(file);
  CHECK(drawn(design).count("profile_x") == 0);
  const std::string limited =
      design.text + "\n[[constraints]]\nresponse = \"profile_x\"\nupper = \"200 mm\"\n";
  const auto names = drawn(problems::read_problem(limited, "f.toml"));
  CHECK(names.count("profile_x") == 1);
  CHECK(names.count("profile_y") == 0);
}

TEST_CASE("what the lines of a picture are is said below it", "[cli][report]") {
  const auto words = [](const char* name) {
    const problems::ProblemStatement design = shipped(name);
    return motion_section(design, scene_svg(design, 60)).html;
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(words("shaft/gripper_path"), Contains("The dashed curve is the path;") &&
                                              !Contains("pitch curve") &&
                                              !Contains("driving part"));
  CHECK_THAT(words("servo_axis/pick_and_place"), Contains("its torque upwards"));
  CHECK_THAT(words("cams/roller_least_base"), Contains("The dashed curve is the pitch curve."));
}

TEST_CASE("a place that rounding leaves beside the cycle's beginning is the beginning",
          "[cli][report]") {
  const problems::ProblemStatement design = shipped("spine_cutter/least_radius");
  const Figure figure = design_figure(design, 60);
  const Panel& panel = figure.panels.front();
  problems::EvaluatedResponse r;
  r.name = panel.y.label, r.unit = "mm", r.along = "deg", r.is_curve = true, r.proved = true;
  r.lowest = 0, r.lowest_at = 1.687e-8, r.highest = 300, r.highest_at = 72;
  CHECK(panel_words(figure, design, {r}).front().extremes ==
        "lowest value 0 mm at 0 deg, highest 300 mm at 72 deg");
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
