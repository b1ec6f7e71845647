// SPDX-License-Identifier: MIT
// What would cure limits that cannot be met, against closed forms.
#include "optim/search/easing.h"

#include <cmath>

#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::easing_test {

using namespace search_tests;

namespace {

std::vector<Easing> eased(const Problem& problem) {
  const Found found = optimise(problem).found;
  REQUIRE(found.assessment.verdict == Verdict::Infeasible);
  return easings(problem, found, OptimiseOptions{}).all;
}

const Easing& named(const std::vector<Easing>& all, const std::string& name) {
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const Easing& e) { return e.name == name; });
  REQUIRE(at != all.end());
  return *at;
}

/// x in [20, 120], y in [0, 10], outer: x + y <= 25 against low: y >= 8.
Problem two_in_each_others_way() {
  Problem problem;
  problem.variables = {variable("x", 20, 120), variable("y", 0, 10)};
  problem.objectives = {least(linear({0}, [](const auto& u) { return u[0]; }))};
  problem.constraints = {
      at_most("outer", linear({0, 1}, [](const auto& u) { return u[0] + u[1]; }), 25),
      at_least("low", linear({1}, [](const auto& u) { return 1.0 * u[0]; }), 8)};
  return problem;
}

}  // namespace

TEST_CASE("each limit and bound that is in the way says by how much it alone must be eased",
          "[optimise]") {
  // x + y is 28 at least: outer must grow by 3, low fall to 5, or the bound of x to 17.
  const std::vector<Easing> all = eased(two_in_each_others_way());
  REQUIRE(all.size() == 3);
  CHECK(named(all, "outer").by == Approx(3));
  CHECK(named(all, "outer").is_upper);
  CHECK(named(all, "low").by == Approx(3));
  CHECK_FALSE(named(all, "low").is_upper);
  const Easing& bound = named(all, "x");
  CHECK(bound.is_bound);
  CHECK_FALSE(bound.is_upper);
  CHECK(bound.bound == 20);
  CHECK(bound.by == Approx(3));
}

TEST_CASE("with a limit eased as told there is a design, and with less there is none",
          "[optimise]") {
  const Problem problem = two_in_each_others_way();
  for (const double share : {1.001, 0.99}) {
    Problem other = problem;
    other.constraints[0].upper = 25 + share * named(eased(problem), "outer").by;
    const Verdict verdict = optimise(other).found.assessment.verdict;
    CHECK(verdict == (share > 1 ? Verdict::Certified : Verdict::Infeasible));
  }
}

TEST_CASE("a limit without which the others contradict one another as well is not told of",
          "[optimise]") {
  // angle, 100 / x <= 2, asks for x >= 50: easing low does not help, nor does easing outer to 33.
  Problem problem = two_in_each_others_way();
  problem.constraints.push_back(
      at_most("angle", convex({0}, [](const auto& u) { return 100.0 / u[0]; }), 2));
  const std::vector<Easing> all = eased(problem);
  for (const Easing& easing : all) {
    INFO(easing.name);
    CHECK(easing.name == "outer");
    CHECK(easing.by == Approx(33));  // to x = 50 with y = 8
  }
  CHECK(all.size() == 1);
}

TEST_CASE("an easing that leaves the objective without a value is not told of", "[optimise]") {
  // The objective sqrt(21 - x) has no value beyond x = 21, where the eased low, x >= 22, would be.
  Problem problem;
  problem.variables = {variable("x", 0, 30, 10), variable("y", 0, 10, 5)};
  problem.objectives = {least(function<Interval>(
      {0},
      [](const auto& u) {
        using std::sqrt;
        return sqrt(21.0 - u[0]);
      },
      Shape::General))};
  problem.constraints = {
      at_most("sum", linear({0, 1}, [](const auto& u) { return u[0] + u[1]; }), 20),
      at_least("low", linear({0}, [](const auto& u) { return 1.0 * u[0]; }), 22)};
  Found infeasible;
  infeasible.x = {20, 0};
  infeasible.assessment.verdict = Verdict::Infeasible;
  infeasible.assessment.blamed = {"sum", "low"};
  for (const Constraint& c : problem.constraints) {
    infeasible.assessment.limits.push_back({.name = c.response.name,
                                            .value = 20,
                                            .bound = c.upper ? 20.0 : 22.0,
                                            .is_upper = c.upper.has_value()});
  }
  const std::vector<Easing> all = easings(problem, infeasible, OptimiseOptions{}).all;
  REQUIRE(all.size() == 1);
  CHECK(all[0].name == "low");  // by 2, at x = 20; sum would grow by 2, at x = 22
  CHECK(all[0].by == Approx(2));
}

TEST_CASE("nothing is told of an answer that meets its limits", "[optimise]") {
  Problem problem = two_in_each_others_way();
  problem.constraints.pop_back();
  const Found found = optimise(problem).found;
  REQUIRE(found.assessment.verdict == Verdict::Certified);
  CHECK(easings(problem, found, OptimiseOptions{}).all.empty());
}

TEST_CASE("what is not looked for in the time that is left is told", "[optimise]") {
  const Problem problem = two_in_each_others_way();
  const Found found = optimise(problem).found;
  CHECK(easings(problem, found, {.time_limit = 60.0}).cut_short.empty());
  const FoundEasings none = easings(problem, found, {.time_limit = 2.0, .spent = 3});
  CHECK(none.all.empty());
  CHECK(none.cut_short == "no time was left after the search");
  CHECK(easings(problem, found, {.time_limit = 1e-9}).cut_short ==
        "cures may take half of the time that the search left");
}

}  // namespace camlaw::optim::easing_test
