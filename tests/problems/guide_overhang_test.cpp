// SPDX-License-Identifier: MIT
// A contact that rubs in its guide stays outside it over the motion that the file has.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

namespace camlaw::problems::guide_overhang_test {
namespace {

/// Up to `to` of the stroke and back, with rests.
std::string cam(const std::string& constants, double to = 1, const std::string& rest = "") {
  return fmt::format(
      "mechanism = 'disc-cam-roller'\n[constants]\n{}[program]\nsegments = [{{name = 'rise', angle "
      "= 80, law = 'cycloidal', to = {}}}, {{name = 'high', angle = 60}}, {{name = 'return', angle "
      "= 100, law = '3-4-5', to = 0}}, {{name = 'low'}}]\n{}",
      constants, to, rest);
}

/// How far the contact stays before its guide, mm; nothing where that is no limit of the problem.
std::optional<double> overhang_left(const std::string& text,
                                    const std::vector<std::string>& settings = {}) {
  ProblemStatement problem = read_problem(text, "f.toml");
  for (const std::string& setting : settings) set_value(problem, setting);
  for (const optim::LimitReport& limit : standing(problem)) {
    if (limit.name == "guide_overhang") return limit.value;
  }
  return {};
}

const std::string kGuided = "stroke = 30\nguide_friction = 0.2\n";

}  // namespace

TEST_CASE("the contact's way out of its guide is by the highest displacement", "[buildable]") {
  CHECK(*overhang_left(cam(kGuided + "overhang = 40\n")) == Approx(10));
  CHECK(*overhang_left(cam(kGuided + "overhang = 20\n")) == Approx(-10));
  CHECK(*overhang_left(cam(kGuided + "overhang = 20\n", 0.5)) == Approx(5));
  CHECK(*overhang_left(cam(kGuided + "overhang = 40\n", 4.0 / 3 + 0.1)) == Approx(-3));
}

TEST_CASE("without friction in the guide nothing is asked of the overhang", "[buildable]") {
  CHECK_FALSE(overhang_left(cam("stroke = 30\noverhang = 20\n")));
  CHECK_FALSE(overhang_left(cam("stroke = 30\noverhang = 20\nguide_friction = 0\n")));
  CHECK(overhang_left(
      cam("stroke = 30\noverhang = 20\n", 1, "[ranges.guide_friction]\nlower = 0\nupper = 0.1\n")));
  CHECK(overhang_left(cam("stroke = 30\noverhang = 20\nguide_friction = 0\n", 1,
                          "[variation.guide_friction]\nplus = 0.2\nminus = 0\n")));
}

TEST_CASE("friction in the guide that is set later brings its limit, or takes it away",
          "[buildable]") {
  const std::string without = cam("stroke = 30\noverhang = 20\n");
  CHECK(*overhang_left(without, {"guide_friction=0.2"}) == Approx(-10));
  CHECK_FALSE(overhang_left(without, {"guide_friction=0.2", "guide_friction=0"}));
  CHECK_FALSE(overhang_left(cam(kGuided + "overhang = 20\n"), {"guide_friction=0"}));
}

TEST_CASE("guides to choose from bring the limit where one of them rubs", "[buildable][parts]") {
  const auto left = [](const std::string& rows, const std::vector<std::string>& settings = {}) {
    HeldFiles files;
    files.tables["guides.csv"] = "name, guide_friction, guide_length [mm]\n" + rows;
    ProblemStatement problem = read_problem(
        cam("stroke = 30\noverhang = 20\n", 1, "[parts.guide]\ncatalogue = 'guides.csv'\n"),
        "f.toml", std::move(files));
    for (const std::string& setting : settings) set_value(problem, setting);
    return std::any_of(problem.constraints.begin(), problem.constraints.end(),
                       [](const auto& c) { return c.response.name == "guide_overhang"; });
  };
  CHECK_FALSE(left("balls, 0, 60\nrollers, 0, 80\n"));
  CHECK_FALSE(left("balls, 0, 60\n"));
  CHECK(left("bronze, 0.2, 60\n"));
  CHECK(left("balls, 0, 60\nbronze, 0.2, 60\n"));
  CHECK(left("balls, 0, 60\nbronze, 0.2, 60\n", {"guide=bronze"}));
}

TEST_CASE("the shortest guide is found where the contact may enter it", "[buildable][optimise]") {
  const auto shortest = [](double friction) {
    const BoundProblem problem(read_problem(
        cam(fmt::format(
                "stroke = 30\nbase_radius = 30\nroller_radius = 8\noffset = 5\nspeed = 200\n"
                "mass = 1.2\nspring_rate = 6\nspring_preload = 50\nguide_friction = {}\n",
                friction),
            1,
            "[variables.guide_length]\nlower = 5\nupper = 200\nstart = 100\n"
            "[variables.overhang]\nlower = 10\nupper = 60\nstart = 50\n"
            "[objective]\nminimize = 'guide_length'\n[buildable]\nrequire = true\n"),
        "f.toml"));
    return optim::optimise(problem.space());
  };
  // The fraction of the force that friction takes is 0.99999 at most, by the moments on the guide
  // with 30 mm of overhang, looked at in 0.01 deg.
  for (const auto& [friction, length] : {std::pair{0.5, 23.6718}, std::pair{1.0, 110.007}}) {
    INFO(friction);
    const optim::Optimum optimum = shortest(friction);
    INFO(optimum.found.assessment.reason);
    CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
    CHECK(optimum.found.x[0] == Approx(length).epsilon(1e-5));
    CHECK(optimum.found.x[1] == Approx(30).epsilon(1e-6));
  }
}

TEST_CASE("a parameter is not sought where it makes no machine", "[optimise]") {
  // The arm, the pivot's distance and the prime circle make a triangle from 40 mm on.
  const BoundProblem problem(read_problem(
      "mechanism = 'disc-cam-oscillating-roller'\n[constants]\nswing = 20\npivot_distance = 150\n"
      "arm_length = 100\nroller_radius = 10\n[variables.base_radius]\nlower = 5\nupper = 100\n"
      "start = 60\n[objective]\nminimize = 'base_radius'\n[program]\nsegments = [{name = 'rise', "
      "angle = 80, law = 'cycloidal'}, {name = 'high', angle = 60}, {name = 'return', angle = 100, "
      "law = '3-4-5'}, {name = 'low'}]\n",
      "f.toml"));
  const optim::Optimum optimum = optim::optimise(problem.space());
  INFO(optimum.found.assessment.reason);
  CHECK(optimum.found.assessment.verdict != optim::Verdict::Certified);
  REQUIRE(optimum.found.x.size() == 1);
  CHECK(optimum.found.x[0] > 40 - 1e-9);
}

}  // namespace camlaw::problems::guide_overhang_test
