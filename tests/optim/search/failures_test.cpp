// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "optim/search/held_inside.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::failures_test {

// Of plain numbers; those of other scalars are found by their arguments.
using std::log;
using std::sqrt;

using namespace search_tests;

TEST_CASE("an optimum near a region without numbers is found", "[optimise]") {
  // x - log(x) / 100 is undefined for x <= 0 and least at 0.01.
  Problem problem;
  problem.variables = {variable("x", -1, 5, 3)};
  problem.objectives = {
      least(function({0}, [](const auto& u) { return u[0] - 0.01 * log(u[0]); }))};
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.01).epsilon(1e-4));
}

TEST_CASE("an optimum on the edge of a region without numbers is come close to", "[optimise]") {
  // Least -x, undefined for x > 1.
  Problem problem;
  problem.variables = {variable("x", -5, 5, -2)};
  problem.objectives = {
      least(function({0}, [](const auto& u) { return 0.0 * sqrt(1.0 - u[0]) - u[0]; }))};
  const Found found = optimise(problem).found;
  REQUIRE(found.x.size() == 1);
  CHECK(found.assessment.verdict == Verdict::Feasible);
  CHECK(found.x[0] <= 1);
  CHECK(found.x[0] > 0.99);
}

TEST_CASE("a search moves along the edge of a stated domain", "[optimise]") {
  // Least x - y, undefined unless x > y^2: the infimum is -1/4, at (1/4, 1/2).
  Problem problem;
  problem.variables = {variable("x", -5, 5, 4), variable("y", -5, 5, -1.5)};
  problem.objectives = {least(function(
      {0, 1}, [](const auto& u) { return 0.0 * sqrt(u[0] - square(u[1])) + u[0] - u[1]; }))};
  problem.domain = [] {
    return std::vector<Function>{
        function({0, 1}, [](const auto& u) { return u[0] - square(u[1]); })};
  };
  const Found found = optimise(problem).found;
  REQUIRE(found.x.size() == 2);
  CHECK(found.assessment.verdict == Verdict::Feasible);
  CHECK(found.assessment.objective.value == Approx(-0.25).epsilon(1e-4));
  CHECK(found.x[1] == Approx(0.5).epsilon(1e-2));
  CHECK_THAT(found.assessment.reason,
             Catch::Contains("optimality hold at this distance from the edge"));
}

TEST_CASE("a problem held inside its domain has numbers outside, and the same inside",
          "[optimise]") {
  Problem problem;
  problem.variables = {variable("x", -5, 5, 4), variable("y", -5, 5, 1)};
  problem.objectives = {least(linear({1}, [](const auto& u) { return 3.0 * u[0]; }))};
  problem.constraints = {
      at_most("root", function({0}, [](const auto& u) { return sqrt(u[0]); }), 1)};
  const auto into = [](Design x) { return std::vector<double>{std::max(x[0], 0.25), x[1]}; };
  const Problem held = held_inside(problem, into);
  const Function& root = held.constraints[0].response.function();
  CHECK(root.value(std::vector{4.0, 1.0}) == 2);
  CHECK(root.value(std::vector{-3.0, 1.0}) == 0.5);
  std::vector<double> slope(root.inputs().size());
  CHECK(root.gradient(std::vector{-3.0, 1.0}, slope) == 0.5);
  CHECK(slope == std::vector{1.0, 0.0});
  const Function& objective = held.objective().response.function();
  CHECK(objective.shape() == Shape::Linear);
  CHECK(objective.value(std::vector{-3.0, 2.0}) == 6);
}

TEST_CASE("a start without numbers does no harm where there are numbers elsewhere", "[optimise]") {
  // (x - 2)^2 + sqrt(x) from x = -3.
  Problem problem;
  problem.variables = {variable("x", -4, 4, -3)};
  problem.objectives = {
      least(function({0}, [](const auto& u) { return square(u[0] - 2.0) + 0.0 * sqrt(u[0]); }))};
  const Found alone = optimise(problem, {.starts = 1}).found;
  CHECK(alone.assessment.verdict == Verdict::Certified);
  CHECK(alone.x[0] == Approx(2).epsilon(1e-6));
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(2).epsilon(1e-6));
  CHECK(found.starts == 8);
  // And where no number is anywhere.
  problem.objectives = {
      least(function({0}, [](const auto& u) { return sqrt(-9.0 - u[0] * u[0]); }))};
  const Found none = optimise(problem, {.starts = 1}).found;
  CHECK(none.assessment.verdict == Verdict::Failed);
  CHECK(none.status == Status::NonFiniteStart);
  CHECK(none.assessment.reason ==
        "the objective cost is undefined: it has no value at the start nor at any of 254 other "
        "designs of the variables' ranges that were looked at");
  CHECK(optimise(problem).found.assessment.verdict == Verdict::Failed);
}

namespace {

/// A stress of 1 + x below a limit, with a value only where the force x is above -0.001 and a limit
/// that keeps it above 0.
Problem stress_under_force(double most_stress) {
  Problem problem;
  problem.variables = {variable("x", -5, 5, 3)};
  problem.objectives = {least(linear({0}, [](const auto& u) { return 1.0 * u[0]; }))};
  Constraint force = {.response = {"force", "N", linear({0}, [](const auto& u) { return u[0]; })},
                      .lower = 0,
                      .scale = 1,
                      .is_edge = true};
  Constraint stress = {
      .response = {"stress", "MPa",
                   function({0},
                            [](const auto& u) { return 1.0 + u[0] + 0.0 * sqrt(u[0] + 0.001); })},
      .upper = most_stress,
      .scale = 1};
  problem.constraints = {force, stress};
  return problem;
}

}  // namespace

TEST_CASE("limits that contradict one another at the edge of a region without numbers are named",
          "[optimise]") {
  // Each eased by the same, they would meet at x = -0.25, where the stress has no value; within the
  // force's limit the stress is 1 at least.
  const Found found = optimise(stress_under_force(0.5)).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(found.assessment.blamed == Names{"force", "stress"});
  CHECK(found.x.at(0) == Approx(0).margin(1e-6));
  // The stress is not known to be convex: elsewhere it could be less.
  CHECK_FALSE(found.assessment.global);
}

TEST_CASE("a design at the edge of a region without numbers is not called infeasible",
          "[optimise]") {
  for (const double most_stress : {1.0, 1.001, 2.0}) {
    const Found found = optimise(stress_under_force(most_stress)).found;
    CHECK(is_feasible(found.assessment));
    CHECK(found.x.at(0) == Approx(0).margin(2e-6));
  }
}

TEST_CASE("what the model throws is a failed assessment with its words", "[optimise]") {
  const auto always = [](std::span<const double>) { throw std::runtime_error("no such follower"); };
  for (const std::string solver : {"auto", "ipopt", "slsqp", "cobyla", "crs2"}) {
    INFO(solver);
    const Found found =
        optimise(valley_of(observed(rosenbrock(), always)), {.solver = solver}).found;
    CHECK(found.assessment.verdict == Verdict::Failed);
    CHECK(found.assessment.reason == "the model raised an error: no such follower");
    CHECK(found.status == Status::Failed);
  }
  const auto odd = [](std::span<const double>) { throw 42; };
  const Found found = optimise(valley_of(observed(rosenbrock(), odd))).found;
  CHECK(found.assessment.verdict == Verdict::Failed);
  CHECK(contains(found.assessment.reason, "the model raised an error"));
}

TEST_CASE("a model that throws on the way never throws out of optimise", "[optimise]") {
  for (const long first : {2, 3, 5, 10, 20, 40}) {
    for (const std::string solver : {"auto", "ipopt", "mma", "bobyqa", "direct-l"}) {
      INFO(solver << " from evaluation " << first);
      long count = 0;
      const auto later = [&](std::span<const double>) {
        if (++count >= first) throw std::runtime_error("worn out");
      };
      const Problem problem = valley_of(observed(rosenbrock(), later));
      Found found;
      REQUIRE_NOTHROW(found = optimise(problem, {.solver = solver}).found);
      if (found.assessment.verdict == Verdict::Failed) {
        CHECK(contains(found.assessment.reason, "worn out"));
      }
    }
  }
}

TEST_CASE("a limit that throws, on a number or a curve, is a failed assessment", "[optimise]") {
  Problem problem = bowl();
  problem.constraints = {at_most(
      "load", observed(sum(), [](auto) { throw std::runtime_error("no such roller"); }), 1)};
  CHECK(contains(optimise(problem).found.assessment.reason, "no such roller"));
  problem.constraints[0].response.measure =
      curve({0, 1}, 0, 1, [](const auto& u, const auto& angle) {
        if (angle > 0.3) throw std::runtime_error("no such angle");
        return u[0] * angle + u[1];
      });
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Failed);
  CHECK(contains(found.assessment.reason, "no such angle"));
}

TEST_CASE("after the time limit the best design so far comes back soon", "[optimise]") {
  int calls = 0;  // each of 5 ms or more: their number does not grow on a busy machine
  const auto slow = [&calls](std::span<const double>) {
    ++calls;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  for (const std::string solver : {"auto", "ipopt", "cobyla", "crs2"}) {
    INFO(solver);
    calls = 0;
    const Problem problem = valley_of(observed(rosenbrock(), slow));
    const Optimum optimum = optimise(problem, {.solver = solver, .time_limit = 0.1});
    CHECK(calls < 1000);
    CHECK(optimum.found.status == Status::TimeLimit);
    CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
    CHECK(contains(optimum.found.assessment.reason, "the time limit of 0.1 s was reached"));
    REQUIRE(optimum.found.x.size() == 2);
    // No worse than the start: 100 (1 - 1.44)^2 + 2.2^2 = 24.2.
    CHECK(optimum.found.assessment.objective.value <= 24.2 + 1e-9);
    CHECK(optimum.found.assessment.objective.value == rosenbrock().value(optimum.found.x));
  }
}

TEST_CASE("the stop flag ends the search with the best design so far", "[optimise]") {
  for (const std::string solver : {"auto", "ipopt", "mma", "cobyla", "isres"}) {
    INFO(solver);
    std::atomic<bool> stop = false;
    int count = 0;
    const auto stopping = [&](std::span<const double>) { stop = ++count >= 12; };
    const Problem problem = valley_of(observed(rosenbrock(), stopping));
    const Found found = optimise(problem, {.solver = solver, .stop = &stop}).found;
    CHECK(found.status == Status::Stopped);
    CHECK(found.assessment.verdict == Verdict::Feasible);
    CHECK(contains(found.assessment.reason, "stopped"));
    CHECK(found.assessment.objective.value <= 24.2 + 1e-9);
    CHECK(count < 200);
  }
}

TEST_CASE("stopped before it began, a search hands back its start", "[optimise]") {
  const std::atomic<bool> stop = true;
  const Found found = optimise(valley_of(rosenbrock()), {.stop = &stop}).found;
  CHECK(found.status == Status::Stopped);
  CHECK(found.x == Point{-1.2, 1});
  CHECK(found.assessment.verdict == Verdict::Feasible);
}

TEST_CASE("a limit of iterations is a status, and the design is feasible", "[optimise]") {
  for (const std::string solver : {"ipopt", "slsqp"}) {
    INFO(solver);
    const Found found =
        optimise(valley_of(rosenbrock()), {.solver = solver, .starts = 1, .max_iterations = 1})
            .found;
    CHECK(found.status == Status::IterationLimit);
    CHECK(found.assessment.verdict == Verdict::Feasible);
    CHECK(contains(found.assessment.reason, "limit of"));
    CHECK(found.assessment.objective.value <= 24.2 + 1e-9);
  }
}

TEST_CASE("an objective without end is a failure that says so", "[optimise]") {
  Problem problem;
  problem.variables = {variable("x", -kInfinity, kInfinity), variable("y", 0, 1)};
  const std::vector<Objective> endless{
      least(linear({0, 1}, [](const auto& u) { return u[0] + u[1]; })),
      most(function({0, 1}, [](const auto& u) { return u[0] * u[0] * u[0] + u[0] - u[1]; })),
      least(function({0}, [](const auto& u) { return u[0] - u[0] * u[0]; }))};
  for (const Objective& objective : endless) {
    problem.objectives = {objective};
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Failed);
    CHECK(found.status == Status::Unbounded);
    CHECK(found.assessment.reason == "the objective improves without bound: a limit is missing");
  }
}

TEST_CASE("a search that ends against a region without numbers has stalled", "[optimise]") {
  // Least -x where the model is undefined for x > 1.
  Problem problem;
  problem.variables = {variable("x", -5, 5, -2)};
  problem.objectives = {
      least(function({0}, [](const auto& u) { return 0.0 * sqrt(1.0 - u[0]) - u[0]; }))};
  for (const std::string solver : {"slsqp", "mma", "lbfgs", "cobyla"}) {
    INFO(solver);
    const Found found = optimise(problem, {.solver = solver}).found;
    CHECK(found.status == Status::Stalled);
    CHECK(found.assessment.verdict == Verdict::Feasible);
  }
}

TEST_CASE("rows that rounding keeps from being met tightly are solved acceptably", "[optimise]") {
  // (x + 1e9) - 1e9 takes multiples of 2^-23 = 1.2e-7 only: 0.3 is missed by 4.8e-8, which the
  // tolerance allows. That is 4.8e-9 of the range of x, 10: more than the 1e-9 that methods aim at.
  Problem problem;
  problem.variables = {variable("x", -5, 5, -1.2), variable("y", -5, 5, 1)};
  problem.objectives = {
      least(convex({0, 1}, [](const auto& u) { return square(u[0] - 2.0) + square(u[1]); }))};
  problem.constraints = {
      equal("coarse", function({0}, [](const auto& u) { return (u[0] + 1e9) - 1e9; }), 0.3)};
  problem.constraints[0].tolerance = 2e-7;
  const Found found = optimise(problem, {.solver = "slsqp", .starts = 1}).found;
  CHECK(found.status == Status::Acceptable);
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.3).margin(3e-7));
}

}  // namespace camlaw::optim::failures_test
