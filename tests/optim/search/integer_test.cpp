// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::integer_test {

using namespace search_tests;

TEST_CASE("few integer combinations are all solved", "[optimise]") {
  // Most 5 a + 4 b where 6 a + 4 b <= 24 and a + 2 b <= 6. Without integers 21 at (3, 3/2);
  // with them b = 0 allows a = 4: 20, b = 1 a = 3: 19, b = 2 a = 2: 18, b = 3 a = 0: 12.
  Problem problem;
  problem.variables = {integer("a", 0, 10), integer("b", 0, 10)};
  problem.objectives = {
      most(linear({0, 1}, [](const auto& u) { return 5.0 * u[0] + 4.0 * u[1]; }))};
  problem.constraints = {
      at_most("hours", linear({0, 1}, [](const auto& u) { return 6.0 * u[0] + 4.0 * u[1]; }), 24),
      at_most("steel", linear({0, 1}, [](const auto& u) { return u[0] + 2.0 * u[1]; }), 6)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.found.x == Point{4, 0});
  CHECK(optimum.found.assessment.objective.value == 20);
  CHECK(optimum.combinations == 121);
  CHECK(optimum.solved == 121);
  CHECK(optimum.found.assessment.global);
  CHECK(contains(optimum.found.assessment.reason, "all 121 combinations were solved"));
}

TEST_CASE("integer and continuous variables together", "[optimise]") {
  // Least (n - 2.4)^2 + (x - n / 2)^2 + x: x = n / 2 - 1/2, and (n - 2.4)^2 + n / 2 - 1/4 over
  // whole n: 1.71 at 1, 0.91 at 2, 1.61 at 3. Bounds that are not whole narrow to 1 .. 6.
  Problem problem;
  problem.variables = {integer("n", 0.5, 6.5, 5), variable("x", -9, 9)};
  problem.objectives = {least(convex({0, 1}, [](const auto& u) {
    return square(u[0] - 2.4) + square(u[1] - 0.5 * u[0]) + u[1];
  }))};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.combinations == 6);
  CHECK(optimum.found.x[0] == 2);
  CHECK(optimum.found.x[1] == Approx(0.5).epsilon(1e-6));
  CHECK(optimum.found.assessment.objective.value == Approx(0.91).epsilon(1e-8));
  CHECK(optimum.found.assessment.global);
}

namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::log;
using std::sin;

/// A convex problem in three integer variables of 0 to 20, 9261 combinations: too many to try.
Problem many_combinations(double most_in_all) {
  Problem problem;
  problem.variables = {integer("a", 0, 20), integer("b", 0, 20, 7), integer("c", 0, 20, 20)};
  problem.objectives = {least(convex({0, 1, 2}, [](const auto& u) {
    return square(u[0] - 4.4) + 2.0 * square(u[1] - 7.5) + square(u[2] - 9.7) + square(u[0] - u[2]);
  }))};
  problem.constraints = {at_most(
      "all", linear({0, 1, 2}, [](const auto& u) { return 3.0 * u[0] + 2.0 * u[1] + u[2]; }),
      most_in_all)};
  return problem;
}

/// The least objective over all combinations that meet the limits, by trying each.
double by_trying(const Problem& problem) {
  double least_value = kInfinity;
  Point x(3);
  for (x[0] = 0; x[0] <= 20; ++x[0]) {
    for (x[1] = 0; x[1] <= 20; ++x[1]) {
      for (x[2] = 0; x[2] <= 20; ++x[2]) {
        const auto meets = [&](const Constraint& c) {
          const double value = c.response.function().value(x);
          return value <= c.upper.value_or(kInfinity) && value >= c.lower.value_or(-kInfinity);
        };
        if (!std::all_of(problem.constraints.begin(), problem.constraints.end(), meets)) continue;
        least_value = std::min(least_value, problem.objective().response.function().value(x));
      }
    }
  }
  return least_value;
}

}  // namespace

TEST_CASE("many integer combinations are searched by branch and bound", "[optimise]") {
  for (const double limit : {1000.0, 37.5, 30.0, 17.2, 0.5}) {
    INFO("limit " << limit);
    const Problem problem = many_combinations(limit);
    const Optimum optimum = optimise(problem);
    const Assessment& a = optimum.found.assessment;
    CHECK(a.verdict == Verdict::Certified);
    CHECK(a.objective.value == Approx(by_trying(problem)).epsilon(1e-9));
    for (const double value : optimum.found.x) CHECK(value == std::round(value));
    CHECK(optimum.combinations == 9261);
    CHECK(optimum.solved < 1000);
    CHECK(a.global);
    CHECK(contains(a.reason, "branch and bound"));
  }
}

TEST_CASE("branch and bound maximises too", "[optimise]") {
  // Most 8 a + 11 b + 6 c where 5 a + 7 b + 4 c <= 14 and each is 0 to 20: a = 0, b = 2 gives 22,
  // a = 2, c = 1 also 22, a = 1, b = 1 19; the relaxation takes a = 14/5: 22.4. Against trying all.
  Problem problem = many_combinations(0);
  problem.objectives = {
      most(linear({0, 1, 2}, [](const auto& u) { return 8.0 * u[0] + 11.0 * u[1] + 6.0 * u[2]; }))};
  problem.constraints = {at_most(
      "weight",
      linear({0, 1, 2}, [](const auto& u) { return 5.0 * u[0] + 7.0 * u[1] + 4.0 * u[2]; }), 14)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.found.assessment.objective.value == Approx(22).epsilon(1e-9));
  CHECK(optimum.combinations == 9261);
}

TEST_CASE("branch and bound certifies nothing that it excluded by problems that are not convex",
          "[optimise]") {
  // Least sin(n) for n of 0 to 30000: n = 11 is close to 7 pi/2, -0.99999.
  Problem problem;
  problem.variables = {integer("n", 0, 30000, 7)};
  problem.objectives = {least(function({0}, [](const auto& u) { return sin(u[0]); }))};
  const Optimum optimum = optimise(problem);
  CHECK_FALSE(optimum.found.assessment.global);
  const bool good = optimum.found.assessment.objective.value <= std::sin(11.0);
  CHECK((good || optimum.found.assessment.verdict != Verdict::Certified));
}

TEST_CASE("no step in one integer or in two leads from what bounds do not settle to better designs",
          "[optimise]") {
  // A narrow valley along a = b, in which no step of one of them leads down, with waves across.
  const auto valley = [](const auto& u) {
    return 50.0 * square(u[0] - u[1]) + square(u[0] - 33.0) + 3.0 * sin(2.0 * u[2]) +
           0.05 * square(u[2] - 20.0);
  };
  Problem problem;
  problem.variables = {integer("a", 0, 40, 3), integer("b", 0, 40, 3), integer("c", 0, 40, 5)};
  problem.objectives = {least(function({0, 1, 2}, valley))};
  const Optimum optimum = optimise(problem);
  const Assessment& a = optimum.found.assessment;
  const Point best = optimum.found.x;
  REQUIRE(a.verdict == Verdict::Feasible);
  CHECK(contains(
      a.reason,
      "no search in those one step away in one integer variable, or in two at once, led to"));
  CHECK(best[0] == 33);
  CHECK(best[1] == 33);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double by_i : {-1.0, 0.0, 1.0}) {
        for (const double by_k : {-1.0, 0.0, 1.0}) {
          Point near = best;
          near[i] += by_i;
          if (k != i) near[k] += by_k;
          CHECK(valley(near) >= a.objective.value);
        }
      }
    }
  }
}

TEST_CASE("integers alone are all tried where bounds say nothing and an evaluation is cheap",
          "[optimise]") {
  // Waves in each of three, whose best values lie apart from those of the steps about the start.
  const auto waves = [](const auto& u) {
    return 5.0 * sin(3.0 * u[0]) * sin(7.0 * u[1]) + 4.0 * sin(5.0 * u[1] + 2.0 * u[2]) +
           0.1 * (u[0] - u[2]);
  };
  Problem problem;
  problem.variables = {integer("a", 0, 12, 3), integer("b", 0, 12, 3), integer("c", 0, 12, 5)};
  problem.objectives = {least(function({0, 1, 2}, waves))};
  double best = kInfinity;
  Point u(3);
  for (u[0] = 0; u[0] <= 12; ++u[0]) {
    for (u[1] = 0; u[1] <= 12; ++u[1]) {
      for (u[2] = 0; u[2] <= 12; ++u[2]) best = std::min(best, waves(u));
    }
  }
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.objective.value == best);
  CHECK(optimum.solved == 2197);  // more than of integers beside other variables
  CHECK(optimum.found.assessment.global);
}

TEST_CASE("integer values at which the model is undefined are passed over", "[optimise]") {
  // (n - 2)^2 + x^2 with numbers for n >= 5 only: 9.
  Problem problem;
  problem.variables = {integer("n", 0, 9, 1), variable("x", -1, 1, 0.5)};
  problem.objectives = {least(function({0, 1}, [](const auto& u) {
    return square(u[0] - 2.0) + square(u[1]) + 0.0 * log(u[0] - 4.5);
  }))};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.x.at(0) == 5);
  CHECK(optimum.found.assessment.objective.value == Approx(9).epsilon(1e-9));
  CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
  CHECK(optimum.found.assessment.reason == "not all of the 10 combinations were settled");
}

TEST_CASE("integers that no limit allows are infeasible, tried one by one", "[optimise]") {
  // 2 a = 3 is met between integers alone.
  Problem problem;
  problem.variables = {integer("a", 0, 10), variable("x", 0, 1)};
  problem.objectives = {least(linear({0, 1}, [](const auto& u) { return u[0] + u[1]; }))};
  problem.constraints = {equal("odd", linear({0}, [](const auto& u) { return 2.0 * u[0]; }), 3)};
  const Optimum optimum = optimise(problem);
  CHECK(optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK(optimum.combinations == 11);
  CHECK(contains(optimum.found.assessment.reason, "none of the 11 combinations"));
  // Over the reals the limit can be met: what is empty are the sets of the eleven combinations.
  REQUIRE(optimum.found.assessment.global);
  CHECK(contains(*optimum.found.assessment.global, "all 11 combinations"));
  CHECK(std::find(optimum.found.assessment.blamed.begin(), optimum.found.assessment.blamed.end(),
                  "odd") != optimum.found.assessment.blamed.end());
}

TEST_CASE("integers that no limit allows are infeasible by branch and bound", "[optimise]") {
  // 0.2 <= a <= 0.8 leaves reals, but no whole a.
  Problem problem = many_combinations(100);
  problem.constraints.push_back(
      {.response = {"narrow", "mm", linear({0}, [](const auto& u) { return u[0]; })},
       .lower = 0.2,
       .upper = 0.8});
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(contains(found.assessment.reason, "none of the 9261 combinations"));
}

TEST_CASE("limits that even real numbers cannot meet are infeasible by branch and bound",
          "[optimise]") {
  // 3 a + 2 b + c <= 3.3 and a + b + c >= 9.9: with a = b = 0 c would be 3.3 and 9.9.
  Problem problem = many_combinations(3.3);
  problem.constraints.push_back(
      at_least("enough", linear({0, 1, 2}, [](const auto& u) { return u[0] + u[1] + u[2]; }), 9.9));
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Infeasible);
  CHECK(contains(found.assessment.reason, "none of the 9261 combinations"));
}

namespace {

/// Least cost (x - target)^2 + price where x <= limit, by option.
ProblemSpace stock(std::vector<double> targets, std::vector<double> prices,
                   std::vector<double> limits) {
  ProblemSpace space;
  Choice size{"size", "mm", {}, {}};
  for (std::size_t i = 0; i < targets.size(); ++i)
    size.options.push_back("size " + std::to_string(i));
  space.choices = {size};
  space.problem = [=](const std::vector<std::size_t>& options) {
    const std::size_t i = options.at(0);
    const double target = targets[i], price = prices[i];
    Problem problem;
    problem.variables = {variable("x", 0, 10, 1)};
    problem.objectives = {least(
        convex({0}, [target, price](const auto& u) { return square(u[0] - target) + price; }))};
    problem.constraints = {
        at_most("reach", linear({0}, [](const auto& u) { return u[0]; }), limits[i])};
    return problem;
  };
  return space;
}

}  // namespace

TEST_CASE("of several options the best is taken, and one that cannot be met is passed over",
          "[optimise]") {
  // Option 0: cost 5. Option 1 would be 0, but x <= -1 cannot be. Option 2: x <= 3 for 4: 1 + 2.
  const Optimum optimum = optimise(stock({2, 2, 4}, {5, 0, 2}, {9, -1, 3}));
  const Assessment& a = optimum.found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(optimum.options == std::vector<std::size_t>{2});
  CHECK(a.objective.value == Approx(3).epsilon(1e-6));
  CHECK(optimum.found.x[0] == Approx(3).epsilon(1e-6));
  CHECK(optimum.combinations == 3);
  CHECK(optimum.solved == 3);
  CHECK(a.global);
  CHECK(a.limits[0].multiplier == Approx(2).epsilon(1e-5));
  CHECK(optimum.problem.constraints[0].upper == 3);
}

TEST_CASE("where no option can be met, the one of least violation is shown", "[optimise]") {
  const Optimum optimum = optimise(stock({2, 2}, {5, 0}, {-3, -1}));
  CHECK(optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK(contains(optimum.found.assessment.reason, "none of the 2 combinations"));
  CHECK(optimum.found.assessment.blamed == Names{"reach", "lower bound of x"});
}

TEST_CASE("an option whose model throws does not hide the others", "[optimise]") {
  for (const std::size_t broken : {0, 1}) {
    ProblemSpace space = stock({2, 2}, {5, 5}, {9, 9});
    const auto sound = space.problem;
    space.problem = [=](const std::vector<std::size_t>& options) {
      Problem problem = sound(options);
      if (options[0] == broken) {
        problem.objectives[0].response.measure =
            observed(problem.objective().response.function(),
                     [](auto) { throw std::runtime_error("no such size"); });
      }
      return problem;
    };
    const Optimum optimum = optimise(space);
    CHECK(optimum.options == std::vector<std::size_t>{1 - broken});
    CHECK(optimum.found.assessment.objective.value == Approx(5).epsilon(1e-9));
    // One option was not settled: the answer is the best known, not the best.
    CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
  }
}

TEST_CASE("choices and integers multiply", "[optimise]") {
  // Two choices of two options and n of 1 to 3: 12 combinations; least |10 i + j - 2 n| by its
  // square: i = 0, j = 1 and n = 1: 1.
  ProblemSpace space;
  space.choices = {{"tens", "", {"0", "10"}, {0, 10}}, {"ones", "", {"1", "7"}, {1, 7}}};
  space.problem = [choices = space.choices](const std::vector<std::size_t>& options) {
    const double offset = choices[0].values[options[0]] + choices[1].values[options[1]];
    Problem problem;
    problem.variables = {integer("n", 1, 3, 2)};
    problem.objectives = {
        least(convex({0}, [offset](const auto& u) { return square(offset - 2.0 * u[0]); }))};
    return problem;
  };
  const Optimum optimum = optimise(space);
  CHECK(optimum.combinations == 12);
  CHECK(optimum.solved == 12);
  // 7 and n = 3 give 1 as well: the first found stays.
  CHECK(optimum.options == std::vector<std::size_t>{0, 0});
  CHECK(optimum.found.x == Point{1});
  CHECK(optimum.found.assessment.objective.value == 1);
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
}

TEST_CASE("progress tells the share of starts and combinations that is through", "[optimise]") {
  ProblemSpace space;
  space.choices = {{"place", "", {"-3", "0", "3"}, {-3, 0, 3}}};
  space.problem = [choices = space.choices](const std::vector<std::size_t>& options) {
    const double place = choices[0].values[options[0]];
    Problem problem;
    problem.variables = {variable("x", -4, 4, 1)};
    problem.objectives = {least(function<Interval>({0}, [place](const auto& u) {
      return square(square(u[0]) - 4.0) + square(u[0] - place);
    }))};
    return problem;
  };
  std::vector<double> shares;
  OptimiseOptions options{.solver = "slsqp", .starts = 4};
  options.progress = [&](const Progress& p) { shares.push_back(p.done); };
  optimise(space, options);
  std::erase(shares, 0);  // and what proves the best at the end tells none
  REQUIRE(shares.size() > 4);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  // Of each combination four starts and what follows them.
  CHECK(shares.front() == Approx(1.0 / 15));  // the second start of the first combination
  CHECK(shares.back() == Approx(13.0 / 15));
}

TEST_CASE("where time runs out among combinations, the best so far is feasible", "[optimise]") {
  Problem problem;
  problem.variables = {integer("a", 0, 400), variable("x", -1, 1, 0.5)};
  int calls = 0;  // each of 2 ms or more: their number does not grow on a busy machine
  problem.objectives = {least(
      observed(convex({0, 1}, [](const auto& u) { return square(u[0] - 300.0) + square(u[1]); }),
               [&calls](auto) {
                 ++calls;
                 std::this_thread::sleep_for(std::chrono::milliseconds(2));
               }))};
  const Optimum optimum = optimise(problem, {.time_limit = 0.3});
  CHECK(calls < 2500);
  CHECK(optimum.solved < 401);
  CHECK(optimum.found.assessment.verdict == Verdict::Feasible);
  REQUIRE(optimum.found.x.size() == 2);
  CHECK(optimum.found.x[0] == std::round(optimum.found.x[0]));
}

TEST_CASE("a choice without options and too many combinations are refused", "[optimise]") {
  ProblemSpace space = ProblemSpace::of(bowl());
  space.choices = {{"empty", "", {}, {}}};
  CHECK_THROWS_WITH(optimise(space), "choice 'empty': it has no options");
  space.choices.assign(6, {"digit", "", Names(10, "option"), {}});
  CHECK_THROWS_AS(optimise(space), std::invalid_argument);
}

}  // namespace camlaw::optim::integer_test
