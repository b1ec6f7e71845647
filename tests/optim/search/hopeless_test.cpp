// SPDX-License-Identifier: MIT
#include "optim/search/hopeless.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "optim/search/optimise.h"
#include "optim/verdict/verdict.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::hopeless_test {

using namespace search_tests;

namespace {

/// Limits on x in [20, 120] and y in [0, 10]: outer, x + y <= 25, contradicts angle, 100 / x <= 2,
/// by itself, and low, y >= 8, with the lower bound of x.
Problem three_in_each_others_way() {
  Problem problem;
  problem.variables = {variable("x", 20, 120), variable("y", 0, 10)};
  problem.objectives = {least(linear({0}, [](const auto& u) { return u[0]; }))};
  problem.constraints = {
      at_most("angle", convex({0}, [](const auto& u) { return 100.0 / u[0]; }), 2),
      at_most("outer", linear({0, 1}, [](const auto& u) { return u[0] + u[1]; }), 25),
      at_least("low", linear({1}, [](const auto& u) { return 1.0 * u[0]; }), 8)};
  return problem;
}

Problem with(Problem problem, const Names& limits) {
  std::erase_if(problem.constraints, [&](const Constraint& c) {
    return std::count(limits.begin(), limits.end(), c.response.name) == 0;
  });
  return problem;
}

}  // namespace

TEST_CASE("limits are blamed that contradict one another, and none without which they do",
          "[optimise]") {
  const Problem problem = three_in_each_others_way();
  const Assessment a = optimise(problem).found.assessment;
  REQUIRE(a.verdict == Verdict::Infeasible);
  Names limits;
  for (const std::string& name : a.blamed) {
    if (name.find("bound of") == std::string::npos) limits.push_back(name);
  }
  CHECK(limits.size() == 2);
  CHECK(optimise(with(problem, limits)).found.assessment.verdict == Verdict::Infeasible);
  for (const std::string& one : limits) {
    INFO(one);
    CHECK(optimise(with(problem, {one})).found.assessment.verdict == Verdict::Certified);
  }
}

TEST_CASE("without narrowing, a blame takes no searches of its own", "[optimise]") {
  const Problem problem = three_in_each_others_way();
  const Found narrowed = optimise(problem).found;
  const Found whole = optimise(problem, {.narrows = false}).found;
  CHECK(whole.assessment.verdict == Verdict::Infeasible);
  CHECK(whole.x == narrowed.x);
  CHECK(whole.assessment.blamed.size() >= narrowed.assessment.blamed.size());
  CHECK(whole.solves < narrowed.solves);
}

TEST_CASE("a limit without a value in one option is not met there", "[optimise]") {
  // With n = 1 acos(n) / 10 is 0, below 0.1; with n = 2 it has no value.
  Problem problem;
  problem.variables = {integer("n", 1, 2, 1)};
  problem.objectives = {most(linear({0}, [](const auto& u) { return 1.0 * u[0]; }))};
  problem.constraints = {at_least("rest",
                                  function({0},
                                           [](const auto& u) {
                                             using std::sqrt;
                                             return sqrt(1.0 - u[0] * u[0]) / 10.0;
                                           }),
                                  0.1)};
  const Assessment a = optimise(problem).found.assessment;
  CHECK(a.verdict == Verdict::Infeasible);
  CHECK(a.blamed == Names{"rest"});
  Problem alone = problem;
  alone.variables = {variable("n", 2, 2, 2)};
  const Assessment b = optimise(alone).found.assessment;
  CHECK(b.verdict == Verdict::Infeasible);
  CHECK(b.reason == "rest cannot be met: it has no value, and n is fixed at 2 by its bounds");
}

namespace {

/// Least x + y in [0, 1]^2 with a root of what is under it from above.
Problem with_root(const std::function<double(double, double)>& plain, Function root) {
  Problem problem;
  problem.variables = {variable("x", 0, 1, 0.1), variable("y", 0, 1, 0.2)};
  problem.objectives = {least(sum_of({0, 1}, {1, 1}))};
  problem.constraints = {at_least("root", std::move(root), 0)};
  REQUIRE(plain(0.1, 0.2) < 0);
  return problem;
}

}  // namespace

TEST_CASE("a limit that has a value at no design is blamed before a search", "[optimise]") {
  const Problem problem =
      with_root([](double x, double y) { return x * y - 2; }, function({0, 1}, [](const auto& u) {
                  using std::sqrt;
                  return sqrt(u[0] * u[1] - 2.0);
                }));
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(found.assessment.blamed == Names{"root"});
  CHECK_FALSE(found.assessment.global);  // nothing proves it
  CHECK(contains(found.assessment.reason, "root cannot be met: it has no value at the start nor"));
  CHECK(found.solves == 0);
}

TEST_CASE("a limit that has a value at some designs is searched for there", "[optimise]") {
  const Problem problem = with_root([](double x, double y) { return x + 2 * y - 1.5; },
                                    function({0, 1}, [](const auto& u) {
                                      using std::sqrt;
                                      return sqrt(u[0] + 2.0 * u[1] - 1.5);
                                    }));
  const Found found = optimise(problem).found;
  CHECK(is_feasible(found.assessment));
  CHECK(found.assessment.objective.value == Approx(0.75).epsilon(1e-3));  // x = 0, y = 0.75
}

}  // namespace camlaw::optim::hopeless_test
