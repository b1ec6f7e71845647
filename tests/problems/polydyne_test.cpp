// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/statement.h"
#include "tests/machines/system_fixture.h"
#include "tests/paths.h"
#include "tests/problems/complaint.h"

/// Programs in problem files whose lift makes up for an elastic follower.
namespace camlaw::problems::polydyne_test {

using Catch::Contains, testing::complaint;

namespace {

std::string text(const std::string& polydyne, const std::string& constants = "",
                 const char* law = "poly-5-6-7-8-9", const char* rest = "",
                 const char* machine = "disc-cam-roller") {
  return fmt::format(
      "mechanism = '{}'\n[constants]\n{}\n[program]\npolydyne = {}\nsegments = ["
      "{{name = 'rise', angle = 120, law = '{}'}}, {{name = 'high', angle = 60}}, "
      "{{name = 'return', angle = 100, law = '{}'}}, {{name = 'low'}}]\n{}",
      machine, constants, polydyne, law, law, rest);
}

double periods(const std::string& file) {
  return values_of(read_problem(file, "f.toml"),
                   find_parameter(read_problem(file, "f.toml"), "polydyne"))
      .front();
}

std::string refusal(const std::string& file) {
  return complaint([&] { read_problem(file, "f.toml"); });
}

}  // namespace

TEST_CASE("a polydyne lift is made for a number of periods, or for a speed", "[polydyne]") {
  CHECK(periods(text("14.5")) == 14.5);
  // sqrt(400e3 / (0.5 * 2)) / (2 pi) Hz, at 10 turns a second.
  const double made = std::sqrt(400e3) / (2 * std::numbers::pi) / 10;
  CHECK(periods(text("'600 rpm'", "mass = 2\nend_share = 0.5\ntrain_stiffness = '400 N/mm'")) ==
        Approx(made).epsilon(1e-12));
  CHECK(periods(text("'10 Hz'", "mass = 2\nend_share = 0.5\ntrain_stiffness = '0.4 MN/m'")) ==
        Approx(made).epsilon(1e-12));
}

TEST_CASE("what makes no polydyne lift is refused in a sentence", "[polydyne]") {
  CHECK_THAT(refusal(text("'600 rpm'")),
             Contains("program.polydyne") && Contains("give train_stiffness in [constants]"));
  CHECK_THAT(refusal(text("'600 rpm'", "train_stiffness = 400", "poly-5-6-7-8-9",
                          "[variables.mass]\nlower = 1\nupper = 2\nstart = 1\n")),
             Contains("mass varies; write a plain number"));
  CHECK_THAT(refusal(text("0")), Contains("program.polydyne"));
  CHECK_THAT(refusal(text("'3 mm'")), Contains("program.polydyne"));
  CHECK_THAT(refusal(text("14.5\npolydyne_damping = 0")), Contains("program.polydyne_damping"));
  CHECK_THAT(refusal(text("14.5\npolydyne_damping = 0.95")),
             Contains("program.polydyne_damping") && Contains("between 0.001 and 0.9"));
  CHECK_THAT(refusal(text("14.5\npolydyne_damping = '3 mm'")),
             Contains("program.polydyne_damping"));
  CHECK_THAT(refusal("mechanism = 'disc-cam-roller'\n[program]\npolydyne_damping = 0.1\nsegments = "
                     "[{name = 'rise', angle = 180, law = 'cycloidal'}, {name = 'return', law = "
                     "'cycloidal'}]\n"),
             Contains("state with polydyne how many natural periods"));
  CHECK_THAT(refusal(text("14.5", "", "modified-sine")),
             Contains("jumps: use laws in which it does not, such as 5-6-7-8-9"));
  CHECK_THAT(refusal(text("'600 rpm'", "", "poly-5-6-7-8-9", "", "servo-axis")),
             Contains("servo-axis has no elastic train; write a plain number"));
}

TEST_CASE("the shipped polydyne lift leaves what the damping makes alone",
          "[polydyne][problem-files]") {
  const auto bound = testing::shipped("cams/polydyne_lift.toml");
  const auto optimum = optim::optimise(bound.space());
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  const ProblemStatement problem =
      read_problem_file(testing::source("problems/cams/polydyne_lift.toml"));
  const auto left = [](const ProblemStatement& p) {
    for (const EvaluatedResponse& r : evaluate(p)) {
      if (r.name == "residual_amplitude") return r.value;
    }
    return std::nan("");
  };
  CHECK(left(problem) < 0.01);
  CHECK(left(problem) > 1e-5);
  ProblemStatement undamped = problem;
  undamped.constants[undamped.mechanism->parameter("train_damping")] = 0;
  CHECK(left(undamped) < 1e-9);
  // With the damping stated to the program too nothing is left.
  std::ifstream file(testing::source("problems/cams/polydyne_lift.toml"));
  std::string whole((std::istreambuf_iterator<char>(file)), {});
  const std::string speed = "polydyne = \"600 rpm\"";
  REQUIRE(whole.find(speed) != std::string::npos);
  whole.replace(whole.find(speed), speed.size(), "polydyne_damping = 0.02\n" + speed);
  CHECK(left(read_problem(whole, "f.toml")) < 1e-9);
}

}  // namespace camlaw::problems::polydyne_test
