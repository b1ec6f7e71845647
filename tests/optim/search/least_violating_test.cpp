// SPDX-License-Identifier: MIT
#include "optim/search/least_violating.h"

#include <algorithm>
#include <stdexcept>

#include "optim/problem/starts.h"
#include "optim/search/local.h"
#include "optim/verdict/verdict.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::least_violating_test {

using namespace search_tests;

namespace {

constexpr std::size_t kWanted = 4;

/// Only the deeper of the two valleys, by x = -1, meets the limit.
Problem one_valley_is_enough() {
  Problem problem = two_valleys();
  problem.constraints = {at_most("depth", problem.objective().response.function(), -0.1)};
  return problem;
}

/// 1, and -1 where x stands at its upper bound of 2: a model that is another one on a face.
class OnFace final : public Kernel {
 public:
  double value(std::span<const double> u) const override { return u[0] == 2 ? -1 : 1; }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::fill(g.begin(), g.end(), 0.0);
    return value(u);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill(h.begin(), h.end(), 0.0);
    return gradient(u, g);
  }
};

}  // namespace

TEST_CASE("places where limits are passed least lie apart, and not where a search ended",
          "[optimise]") {
  const Problem problem = one_valley_is_enough();
  const Scales its = scales(problem, problem.start());
  const std::vector<double> known{0.97, 0};
  const auto places = least_violating(problem, its, known, kWanted, 1);
  REQUIRE(places.size() == kWanted);
  CHECK(std::abs(places[0][0] + 1) < 0.4);  // in the other valley
  const auto apart = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::abs(a[0] - b[0]) > 0.4 || std::abs(a[1] - b[1]) > 0.4;
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(apart(places[i], known));
    for (std::size_t k = 0; k < i; ++k) CHECK(apart(places[i], places[k]));
    if (i == 0) continue;
    CHECK(largest_violation(problem, its, places[i]) >=
          largest_violation(problem, its, places[i - 1]));
  }
}

TEST_CASE("where the limits leave no convex set a second valley is found", "[optimise]") {
  Problem problem = one_valley_is_enough();
  problem.objectives = {least(linear({1}, [](const auto& u) { return 1.0 * u[0]; }))};
  OptimiseOptions once;
  once.starts = 1;
  const Optimum optimum = optimise(problem, once);
  REQUIRE(is_feasible(optimum.found.assessment));
  CHECK(optimum.found.x[0] < 0);
}

TEST_CASE("a design that there is on a face of the box alone is found", "[optimise]") {
  Problem problem;
  problem.variables = {variable("x", -2, 2, 0.3), variable("y", 1, 3, 2)};
  problem.objectives = {least(linear({1}, [](const auto& u) { return 1.0 * u[0]; }))};
  problem.constraints = {at_most("on face", {{0}, std::make_shared<OnFace>()}, 0)};
  const Optimum optimum = optimise(problem);
  REQUIRE(is_feasible(optimum.found.assessment));
  CHECK(optimum.found.x[0] == 2);
  CHECK(optimum.found.assessment.objective.value == Approx(1).margin(1e-6));
}

TEST_CASE("what a model throws elsewhere does not take back that limits contradict", "[optimise]") {
  Problem problem = one_valley_is_enough();
  problem.constraints[0].upper = -10;  // no valley is as deep
  const Optimum quiet = optimise(problem);
  CHECK(quiet.found.assessment.verdict == Verdict::Infeasible);
  // A place that no search comes to by itself, only the look all over the box.
  const std::vector<double> there = starts(problem, 128, OptimiseOptions{}.seed)[100];
  int times = 0;
  problem.constraints[0].response.measure =
      observed(problem.constraints[0].response.function(), [&](std::span<const double> u) {
        if (!std::ranges::equal(u, there)) return;
        ++times;
        throw std::runtime_error("not here");
      });
  CHECK(optimise(problem).found.assessment.verdict == Verdict::Infeasible);
  CHECK(times > 0);
}

TEST_CASE("a quasiconvex limit that is gentle about a design may be met elsewhere", "[optimise]") {
  const Function cube = function<Interval>(
      {0}, [](const auto& u) { return u[0] * u[0] * u[0]; }, Shape::Quasilinear);
  Problem problem;
  problem.variables = {variable("p", -1, 2)};
  problem.objectives = {least(linear({0}, [](const auto& u) { return 1.0 * u[0]; }))};
  problem.constraints = {at_least("cube", cube, 1)};
  for (const double start : {0.0, -0.05, -0.01, 0.3}) {
    INFO(start);
    problem.variables[0].start = start;
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.x[0] == Approx(1));
  }
  for (const double p : {0.0, 0.02, 0.05, 0.1, 0.2}) {
    INFO(p);
    const Point x{p};
    CHECK(!assess_least_violation(problem, scales(problem, x), x).global);
  }
}

TEST_CASE("after a first start that led to no design others try the first method alone",
          "[optimise]") {
  Problem problem = two_valleys();
  problem.constraints = {at_most("depth", problem.objective().response.function(), -10)};
  const Deadline none({}, nullptr);
  const auto solves_told = [&](FirstStart first) {
    const FromStart second = search_one_start(problem, {}, none, 1, first);
    CHECK_FALSE(is_feasible(second.trail.found.assessment));
    return second.trail.found.solves;
  };
  CHECK(solves_told(FirstStart::NoDesign) < solves_told(FirstStart::Led));
  const Optimum answer = optimise(problem);
  CHECK(answer.found.assessment.verdict == Verdict::Infeasible);
  CHECK(answer.found.assessment.blamed == std::vector<std::string>{"depth"});
}

}  // namespace camlaw::optim::least_violating_test
