// SPDX-License-Identifier: MIT
#include "optim/search/hopeless.h"

#include <algorithm>

#include "optim/search/optimise.h"
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

}  // namespace camlaw::optim::hopeless_test
