// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "optim/problem/starts.h"
#include "optim/search/exchange.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::optimise_test {

// Of plain numbers; those of other scalars are found by their arguments.
using std::sin;

using namespace search_tests;

TEST_CASE("an optimum is certified, and found by the method that auto names", "[optimise]") {
  const Optimum optimum = optimise(bowl());
  const Found& found = optimum.found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.status == Status::Solved);
  CHECK(found.x[0] == Approx(10.0 / 7).epsilon(1e-6));
  CHECK(found.x[1] == Approx(-6.0 / 7).epsilon(1e-6));
  CHECK(found.assessment.objective.value == Approx(-11.0 / 14).epsilon(1e-10));
  CHECK(found.assessment.global);
  CHECK(found.solver == "slsqp");
  CHECK(contains(found.why_solver, "slsqp"));
  CHECK(found.starts == 1);
  CHECK(found.agreed == 1);
  CHECK(found.evaluations > 0);
  CHECK(found.solves >= 1);
  CHECK(optimum.combinations == 1);
  CHECK(optimum.solved == 1);
  CHECK(optimum.options.empty());
  CHECK(optimum.wall_s > 0);
}

TEST_CASE("limits, equations and maximising", "[optimise]") {
  // On x + y = 1 the bowl is 2 x^2 - 7 x + 11/2: x = 7/4, y = -3/4, -5/8.
  for (const bool equation : {false, true}) {
    Problem problem = bowl();
    problem.constraints = {equation ? equal("sum", sum(), 1) : at_least("sum", sum(), 1)};
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.x[0] == Approx(1.75).epsilon(1e-6));
    CHECK(found.x[1] == Approx(-0.75).epsilon(1e-6));
    CHECK(found.assessment.objective.value == Approx(-0.625).epsilon(1e-8));
    CHECK(found.assessment.active == Names{"sum"});
  }
  // Most x + y in the disc of radius 2: 2 sqrt(2) at (sqrt 2, sqrt 2).
  Problem problem = bowl();
  problem.objectives = {most(sum())};
  problem.constraints = {at_most(
      "radius", convex({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }), 4)};
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(2 * std::sqrt(2)).epsilon(1e-6));
  // d(r sqrt 2)/d(r^2) = 1 / (r sqrt 2).
  CHECK(found.assessment.limits[0].multiplier == Approx(1 / (2 * std::sqrt(2))).epsilon(1e-5));
}

TEST_CASE("two limits that contradict each other are blamed, an innocent one is not",
          "[optimise]") {
  // 3 - x and x^2 - 1 are equal where x^2 + x = 4: x = (sqrt(17) - 1) / 2.
  Problem problem;
  problem.variables = {variable("x", -5, 5), variable("y", -5, 5)};
  problem.objectives = {least(convex({1}, [](const auto& u) { return square(u[0]); }))};
  problem.constraints = {
      at_least("low", linear({0}, [](const auto& u) { return u[0]; }), 3),
      at_most("innocent", linear({0, 1}, [](const auto& u) { return u[0] + u[1]; }), 100),
      at_most("high", convex({0}, [](const auto& u) { return square(u[0]); }), 1)};
  problem.constraints[0].scale = problem.constraints[2].scale = 1;
  const Optimum optimum = optimise(problem);
  const Assessment& a = optimum.found.assessment;
  CHECK(a.verdict == Verdict::Infeasible);
  CHECK(a.blamed == Names{"low", "high"});
  CHECK(a.reason == "low and high contradict one another");
  CHECK(a.global);
  const double x = (std::sqrt(17) - 1) / 2;
  CHECK(optimum.found.x[0] == Approx(x).epsilon(1e-6));
  CHECK(a.limits[0].margin == Approx(x - 3).epsilon(1e-6));
  CHECK(a.limits[1].met);
  CHECK(a.limits[2].margin == Approx(1 - x * x).epsilon(1e-6));
  CHECK(optimum.found.status == Status::Infeasible);
}

TEST_CASE("a variable's bound is blamed with the limit that it contradicts", "[optimise]") {
  Problem problem = bowl();
  problem.variables[0].upper = 1;
  problem.constraints = {at_least("reach", linear({0}, [](const auto& u) { return u[0]; }), 2)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK(optimum.found.assessment.blamed == Names{"reach", "upper bound of x"});
  CHECK(optimum.found.x[0] == Approx(1).epsilon(1e-8));
  CHECK(optimum.found.x[0] <= 1);
  CHECK(optimum.found.assessment.limits[0].margin == Approx(-1).epsilon(1e-7));
}

TEST_CASE("equations and limits over the cycle are blamed too", "[optimise]") {
  // x = 1/2, and x sin(a) <= -1 over a of 1 to 2: for x < 0 it is highest at a = 1. Both are missed
  // by as much where 1/2 - x = x sin(1) + 1.
  Problem problem = bowl();
  problem.constraints = {
      equal("fixed", linear({0}, [](const auto& u) { return u[0]; }), 0.5),
      {.response = {"wave", "mm",
                    curve<Interval>(
                        {0}, 1, 2,
                        [](const auto& u, const auto& angle) { return u[0] * sin(angle); },
                        Shape::Linear)},
       .upper = -1}};
  for (Constraint& c : problem.constraints) c.scale = 1;
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(found.assessment.blamed == Names{"fixed", "wave"});
  CHECK(found.x[0] == Approx(-0.5 / (1 + std::sin(1))).epsilon(1e-6));
  CHECK(found.assessment.limits[1].worst_angle == 1);
}

TEST_CASE("limits that only touch are met", "[optimise]") {
  // x <= 1 and x >= 1: one value of x is left.
  Problem problem = bowl();
  problem.constraints = {at_most("high", linear({0}, [](const auto& u) { return u[0]; }), 1),
                         at_least("low", linear({0}, [](const auto& u) { return u[0]; }), 1)};
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(1).epsilon(1e-6));
  CHECK(found.x[1] == Approx(-0.75).epsilon(1e-6));  // 4 (y + 1/2) + 1 = 0
}

TEST_CASE("equations that say the same twice are certified, without unique multipliers",
          "[optimise]") {
  // Least x^2 + y^2 where x + y = 2: (1, 1). With a third variable, z^2, and without: then there
  // are as many equations as variables, and still a line of designs.
  for (const bool third : {true, false}) {
    INFO((third ? "three" : "two") << " variables");
    Problem problem;
    problem.variables = {variable("x", -5, 5, 3), variable("y", -5, 5, -1)};
    problem.objectives = {
        least(convex({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }))};
    if (third) {
      problem.variables.push_back(variable("z", -5, 5, 2));
      problem.objectives = {least(convex(
          {0, 1, 2}, [](const auto& u) { return square(u[0]) + square(u[1]) + square(u[2]); }))};
    }
    problem.constraints = {
        equal("once", sum(), 2),
        equal("twice", linear({0, 1}, [](const auto& u) { return 2.0 * u[0] + 2.0 * u[1]; }), 4)};
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.x[0] == Approx(1).epsilon(1e-6));
    CHECK(found.x[1] == Approx(1).epsilon(1e-6));
    CHECK(std::isinf(found.assessment.condition));
    // The optimum c^2 / 2 rises by c = 2 to each unit of x + y, whichever equation moves.
    const auto& limits = found.assessment.limits;
    CHECK(limits[0].multiplier + 2 * limits[1].multiplier == Approx(2).epsilon(1e-6));
  }
}

TEST_CASE("three limits through one point of the plane are certified", "[optimise]") {
  // Most x + 2 y where x <= 1, y <= 1, x + y <= 2: (1, 1).
  Problem problem;
  problem.variables = {variable("x", -5, 5), variable("y", -5, 5)};
  problem.objectives = {most(linear({0, 1}, [](const auto& u) { return u[0] + 2.0 * u[1]; }))};
  problem.constraints = {at_most("right", linear({0}, [](const auto& u) { return u[0]; }), 1),
                         at_most("top", linear({1}, [](const auto& u) { return u[0]; }), 1),
                         at_most("corner", sum(), 2)};
  const Found found = optimise(problem).found;
  const Assessment& a = found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.objective.value == Approx(3).epsilon(1e-7));
  CHECK(a.active == Names{"right", "top", "corner"});
  CHECK(std::isinf(a.condition));
  CHECK(a.limits[0].multiplier + a.limits[2].multiplier == Approx(1).epsilon(1e-6));
  CHECK(a.limits[1].multiplier + a.limits[2].multiplier == Approx(2).epsilon(1e-6));
}

TEST_CASE("a saddle as the start is not certified", "[optimise]") {
  // x^2 - y^2 + y^4 / 2 is stationary at the origin; it is least, -1/2, at (0, +-1).
  Problem problem;
  problem.variables = {variable("x", -2, 2), variable("y", -2, 2)};
  problem.objectives = {least(function({0, 1}, [](const auto& u) {
    return square(u[0]) - square(u[1]) + 0.5 * square(square(u[1]));
  }))};
  const Found stuck = optimise(problem, {.starts = 1}).found;
  const bool escaped = std::abs(std::abs(stuck.x[1]) - 1) < 1e-3;
  CHECK((stuck.assessment.verdict == Verdict::Certified) == escaped);
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(-0.5).epsilon(1e-8));
  CHECK(std::abs(found.x[1]) == Approx(1).epsilon(1e-5));
}

TEST_CASE("of two valleys the deeper one is found, and the starts that agree are counted",
          "[optimise]") {
  const Problem problem = two_valleys();
  const double x = valley(-1), deepest = std::pow(x * x - 1, 2) + x / 5;
  CHECK(std::abs(4 * x * x * x - 4 * x + 0.2) < 1e-14);
  constexpr int kStarts = 12;
  const Found found = optimise(problem, {.starts = kStarts}).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK_FALSE(found.assessment.global);
  CHECK(found.x[0] == Approx(x).epsilon(1e-6));
  CHECK(found.assessment.objective.value == Approx(deepest).epsilon(1e-9));
  CHECK(found.starts == kStarts);
  // Each start alone: both valleys are met, and the count is right.
  int deep = 0;
  for (const Point& start : starts(problem, kStarts, 1)) {
    const Attempt alone =
        exchange(problem, scales(problem, start), start, find_solver("slsqp"), {});
    deep += std::abs(problem.objective().response.function().value(alone.x) - deepest) < 1e-6;
  }
  CHECK(found.agreed == deep);
  CHECK(deep > 0);
  CHECK(deep < kStarts);
}

TEST_CASE("the start that led to the answer agrees with it", "[optimise]") {
  // (x^2 + y^2 - 2)^2 <= 0: a circle on which the limit has no gradient. Methods in turn end at
  // points that differ by more than 1e-6; one of them is the answer.
  Problem problem;
  problem.variables = {variable("x", -5, 5, 3), variable("y", -5, 5, -1)};
  problem.objectives = {
      least(convex({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }))};
  problem.constraints = {at_most(
      "circle",
      function({0, 1}, [](const auto& u) { return square(square(u[0]) + square(u[1]) - 2.0); }),
      0)};
  problem.constraints[0].tolerance = 1e-6;
  const Found found = optimise(problem, {.starts = 1}).found;
  CHECK(is_feasible(found.assessment));
  CHECK(found.agreed == 1);
}

TEST_CASE("fixed variables stay where they are", "[optimise]") {
  // y = 1/2 is given: 2 (x - 1) + 1/2 = 0.
  Problem problem = bowl();
  problem.variables[1] = variable("y", 0.5, 0.5, 0.5);
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.75).epsilon(1e-6));
  CHECK(found.x[1] == 0.5);
  CHECK(found.assessment.variables[1].multiplier == 0);
  CHECK_FALSE(found.assessment.variables[1].at_lower);
  // Not a bit off either where scaling rounds.
  problem.variables[1] = variable("y", 0.1, 0.1, 0.1);
  problem.variables[1].scale = 3;
  CHECK(optimise(problem).found.x[1] == 0.1);
  // And where nothing varies, the one design is judged.
  problem.variables[0] = variable("x", 1, 1, 1);
  const Found only = optimise(problem).found;
  CHECK(only.assessment.verdict == Verdict::Certified);
  CHECK(only.x == Point{1, 0.1});
}

TEST_CASE("a problem without variables is judged as it stands", "[optimise]") {
  const auto number = [](double c) {
    return linear({}, [c](const auto& u) {
      using T = std::remove_cvref_t<decltype(u[0])>;
      return constant<T>(c);
    });
  };
  Problem problem;
  problem.objectives = {least(number(4))};
  problem.constraints = {at_most("load", number(2), 3)};
  for (const std::string solver : {"auto", "ipopt", "cobyla", "crs2"}) {
    INFO(solver);
    problem.constraints[0].upper = 3;
    const Found met = optimise(problem, {.solver = solver}).found;
    CHECK(met.assessment.verdict == Verdict::Certified);
    CHECK(met.assessment.objective.value == 4);
    CHECK(met.x.empty());
    problem.constraints[0].upper = 1;
    const Found passed = optimise(problem, {.solver = solver}).found;
    CHECK(passed.assessment.verdict == Verdict::Infeasible);
    CHECK(passed.assessment.blamed == Names{"load"});
  }
}

TEST_CASE("an unknown solver is refused with the list of known ones", "[optimise]") {
  try {
    optimise(bowl(), {.solver = "simplex"});
    FAIL("no exception");
  } catch (const std::invalid_argument& e) {
    CHECK(contains(e.what(), "'simplex'"));
    for (const std::string& name : solver_names()) CHECK(contains(e.what(), name));
  }
  CHECK_THROWS_AS(optimise(bowl(), {.starts = 0}), std::invalid_argument);
}

TEST_CASE("a problem that is not well posed is refused", "[optimise]") {
  Problem problem = bowl();
  problem.variables[0].lower = 5;
  CHECK_THROWS_WITH(optimise(problem), "variable 'x': lower 5 exceeds upper 3");
}

TEST_CASE("statuses have words of their own", "[optimise]") {
  std::set<std::string_view> words;
  for (const Status status :
       {Status::Solved, Status::Acceptable, Status::Stalled, Status::IterationLimit,
        Status::TimeLimit, Status::Infeasible, Status::Unbounded, Status::NonFiniteStart,
        Status::Stopped, Status::Failed}) {
    words.insert(to_string(status));
  }
  CHECK(words.size() == 10);
  CHECK_FALSE(words.contains("?"));
}

TEST_CASE("a search takes a problem with one objective", "[optimise]") {
  Problem problem = bowl();
  problem.objectives.push_back(problem.objective());
  CHECK_THROWS_WITH(optimise(problem),
                    "optimise() takes one objective, but this problem has 2; use pareto() to find "
                    "their front");
  problem.objectives.clear();
  CHECK_THROWS_WITH(optimise(problem), "a problem needs an objective");
}

}  // namespace camlaw::optim::optimise_test
