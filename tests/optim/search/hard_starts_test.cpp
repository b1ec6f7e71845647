// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "optim/cycle/scales.h"
#include "optim/verdict/verdict.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::hard_starts_test {

using namespace search_tests;

namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::cos;
using std::exp;
using std::log;
using std::sin;
using std::sqrt;

/// The least of f over [low, high] by golden section, for functions with one valley.
template <class F>
double least_of(const F& f, double low, double high) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  for (int i = 0; i < 200; ++i) {
    const double left = high - ratio * (high - low), right = low + ratio * (high - low);
    (f(left) < f(right) ? high : low) = f(left) < f(right) ? right : left;
  }
  return f((low + high) / 2);
}

}  // namespace

TEST_CASE("a start beside a pole makes no false certificate", "[optimise]") {
  Problem many;
  double expected = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    many.variables.push_back(variable("r" + std::to_string(i), 1e-3, 10, 1e-3));
    const double pull = 1 + 0.1 * static_cast<double>(i);
    expected += least_of([&](double r) { return 1 / (r * r * r) + pull * r; }, 0.1, 10);
  }
  std::vector<std::size_t> all(40);
  for (std::size_t i = 0; i < 40; ++i) all[i] = i;
  many.objectives = {least(convex(all, [](const auto& u) {
    auto sum = 0.0 * u[0];
    for (std::size_t i = 0; i < 40; ++i) {
      const double pull = 1 + 0.1 * static_cast<double>(i);
      sum = sum + 1.0 / (u[i] * u[i] * u[i]) + pull * u[i];
    }
    return sum;
  }))};
  const Found found = optimise(many).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(expected).epsilon(1e-6));
}

TEST_CASE("a limit with a pole at the start is met, not called impossible", "[optimise]") {
  for (const double low : {1e-2, 1e-4}) {
    INFO(low);
    Problem problem;
    problem.variables = {variable("r", low, 10, low)};
    problem.objectives = {most(linear({0}, [](const auto& u) { return u[0]; }))};
    problem.constraints = {at_most(
        "stress", convex({0}, [](const auto& u) { return 1.0 / (u[0] * u[0] * u[0]) + u[0]; }), 3)};
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    double r = 3;
    for (int i = 0; i < 100; ++i) r = 3 - 1 / (r * r * r);
    CHECK(found.x.at(0) == Approx(r).epsilon(1e-6));
  }
}

TEST_CASE("what grows without end is not certified", "[optimise]") {
  const auto unbounded = [](Function gain) {
    Problem problem;
    problem.variables = {variable("x", 0, kInfinity, 1)};
    problem.objectives = {most(std::move(gain))};
    return problem;
  };
  const auto concave = [](auto f) { return function<Interval>({0}, f, Shape::Concave); };
  for (const Problem& problem :
       {unbounded(concave([](const auto& u) { return sqrt(u[0]); })),
        unbounded(concave([](const auto& u) { return log(u[0] + 1.0); }))}) {
    const Assessment a = optimise(problem).found.assessment;
    CHECK(a.verdict != Verdict::Certified);
    CHECK_FALSE(a.global);
    const std::vector<double> far{1e7};
    CHECK(assess(problem, scales(problem, problem.start()), far, true).verdict !=
          Verdict::Certified);
  }
}

TEST_CASE("a search that begins at the optimum stays there", "[optimise]") {
  Problem at_bottom = bowl();
  at_bottom.variables[0].start = 10.0 / 7;
  at_bottom.variables[1].start = -6.0 / 7;
  const Found found = optimise(at_bottom).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(-11.0 / 14).epsilon(1e-9));

  Problem growing;  // e^x on [-40, 0]
  growing.variables = {variable("x", -40, 0, -40)};
  growing.objectives = {most(convex({0}, [](const auto& u) { return exp(u[0]); }))};
  CHECK(optimise(growing).found.assessment.verdict != Verdict::Failed);
}

TEST_CASE("a search of combinations that is cut short calls nothing infeasible", "[optimise]") {
  // k = 0 cannot be; k = 1 can. The flag stops the search after the first.
  std::atomic<bool> stop{false};
  int seen = 0;
  Problem problem;
  problem.variables = {integer("k", 0, 1, 0), variable("x", 0, 1, 0.5)};
  const Function cost = convex({0, 1}, [](const auto& u) { return u[0] + square(u[1] - 0.3); });
  problem.objectives = {least(observed(cost, [&](std::span<const double> u) {
    if (u[0] == 0 && ++seen > 3) stop = true;
  }))};
  problem.constraints = {at_least("enough", linear({0}, [](const auto& u) { return u[0]; }), 0.4)};
  const Assessment a = optimise(problem, {.stop = &stop}).found.assessment;
  CHECK(a.verdict != Verdict::Infeasible);
  CHECK_FALSE(a.global);
  stop = false;
  const Found whole_search = optimise(problem).found;
  CHECK(whole_search.assessment.verdict == Verdict::Certified);
  CHECK(whole_search.x.at(0) == 1);
}

TEST_CASE("a limit that is level at the start is met in combinations too", "[optimise]") {
  // A narrow hill, whose slope at the start is 0 in doubles: nothing leads to it from there.
  const auto hill = [](Shape shape) {
    return function<Interval>(
        {1, 2},
        [](const auto& u) { return exp(-100.0 * (square(u[0] - 0.63) + square(u[1] - 0.41))); },
        shape);
  };
  for (const Shape shape : {Shape::Quasiconcave, Shape::General}) {
    Problem problem;
    problem.variables = {integer("k", 1, 2, 1), variable("p", 0, 1, 0.1), variable("q", 0, 1, 0.1)};
    problem.objectives = {least(sum_of({0, 1, 2}, {1, 1, 1}))};
    problem.constraints = {at_least("height", hill(shape), 0.5)};
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    // The nearest point of the circle of this height, towards (0, 0).
    const double radius = std::sqrt(std::log(2.0) / 100);
    CHECK(found.assessment.objective.value ==
          Approx(1 + 0.63 + 0.41 - radius * std::sqrt(2.0)).epsilon(1e-6));
  }
}

TEST_CASE("combinations are searched from the start's outwards", "[optimise]") {
  std::vector<double> order;
  Problem problem;
  problem.variables = {integer("k", 0, 5, 3)};
  const Function cost = linear({0}, [](const auto& u) { return 1.0 * u[0]; });
  problem.objectives = {least(observed(cost, [&](std::span<const double> u) {
    if (order.empty() || order.back() != u[0]) order.push_back(u[0]);
  }))};
  optimise(problem);
  REQUIRE(order.size() >= 6);
  order.resize(6);
  CHECK(order == Point{3, 4, 2, 5, 1, 0});
}

TEST_CASE("a quasiconvex objective that is level where it was found is not the best of all",
          "[optimise]") {
  const auto ninth = [](const auto& u) {
    const auto third = u[0] * u[0] * u[0];
    return third * third * third;
  };
  Problem problem;
  problem.variables = {variable("x", -1, 1, 0)};
  problem.objectives = {least(function<Interval>({0}, ninth, Shape::Quasilinear))};
  const Assessment alone = optimise(problem).found.assessment;
  CHECK((alone.verdict != Verdict::Certified || alone.objective.value < -0.99));
  problem.variables.push_back(integer("k", 0, 1, 0));
  problem.objectives = {least(function<Interval>(
      {0, 1},
      [&](const auto& u) {
        const auto third = u[0] * u[0] * u[0];
        return third * third * third + u[1];
      },
      Shape::Quasilinear))};
  const Assessment both = optimise(problem).found.assessment;
  CHECK((!both.global || both.objective.value < -0.99));
}

TEST_CASE("an error that can be brought to zero is proved to be", "[optimise]") {
  // a cos w + b sin w - cos(w - 0.3): an exact fit, of the error nothing is left but rounding.
  Problem problem;
  problem.variables = {variable("a", -2, 2, 0.1), variable("b", -2, 2, -0.4)};
  problem.objectives = {{{"error", "mm",
                          curve<Interval>(
                              {0, 1}, 0, 6,
                              [](const auto& u, const auto& w) {
                                using T = std::remove_cvref_t<decltype(w)>;
                                return u[0] * cos(w) + u[1] * sin(w) - cos(w - constant<T>(0.3));
                              },
                              Shape::Linear)},
                         Sense::Minimize,
                         Part::Magnitude,
                         {}}};
  const Found found = optimise(problem).found;
  INFO(found.assessment.reason);
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x.at(0) == Approx(std::cos(0.3)).epsilon(1e-8));
  CHECK(found.x.at(1) == Approx(std::sin(0.3)).epsilon(1e-8));
}

TEST_CASE("methods that search the whole box take peaks as numbers", "[optimise]") {
  // Least highest of (x - 1)^2 + y^2 + x cos w / 10 over the cycle, from w = 0 or pi.
  Problem problem;
  problem.variables = {variable("x", -3, 3, -2), variable("y", -3, 3, 2)};
  problem.objectives = {{{"peak", "mm",
                          curve<Interval>(
                              {0, 1}, 0, 6.28,
                              [](const auto& u, const auto& w) {
                                using T = std::remove_cvref_t<decltype(w)>;
                                const T off = u[0] - constant<T>(1);
                                return off * off + u[1] * u[1] + constant<T>(0.1) * u[0] * cos(w);
                              },
                              Shape::Convex)},
                         Sense::Minimize,
                         Part::Highest,
                         {}}};
  const double expected = least_of([](double x) { return (x - 1) * (x - 1) + x / 10; }, 0, 2);
  for (const char* name : {"direct-l", "crs2", "isres", "esch", "mlsl"}) {
    INFO(name);
    const Found found = optimise(problem, {.solver = name, .max_evaluations = 2000}).found;
    CHECK(found.assessment.verdict == Verdict::Certified);
    CHECK(found.assessment.objective.value == Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("a limit that nothing moves is blamed at once", "[optimise]") {
  Problem problem = bowl();
  problem.variables.push_back(variable("load", 5, 5, 5));
  const auto blamed_at_once = [&problem] {
    const Found found = optimise(problem).found;
    CHECK(found.assessment.verdict == Verdict::Infeasible);
    CHECK(found.assessment.blamed == Names{"load"});
    CHECK(found.assessment.reason ==
          "load cannot be met: load is fixed at 5 by its bounds, and no other variable changes "
          "it");
    CHECK(found.assessment.global);
    CHECK(found.evaluations == 0);
  };
  problem.constraints = {at_most("load", linear({2}, [](const auto& u) { return 1.0 * u[0]; }), 4)};
  blamed_at_once();
  // Over the cycle it rises from 5 to 10.04 and falls to 9.75.
  auto& measure = problem.constraints[0].response.measure;
  measure = curve({2}, 0, 1, [](const auto& u, const auto& angle) {
    return u[0] * (1.0 + angle * (2.5 - 1.55 * angle));
  });
  blamed_at_once();
  problem.constraints[0].upper = 20;
  CHECK(is_feasible(optimise(problem).found.assessment));
  problem.constraints[0].lower = 6;
  blamed_at_once();
  // What a variable moves is searched for: at x = 1 all of it is above 6.
  problem.variables[0].upper = 1;
  measure = curve({0, 2}, 0, 1, [](const auto& u, const auto& angle) {
    return u[0] + u[1] * (1.0 + angle * (2.5 - 1.55 * angle));
  });
  const Found found = optimise(problem).found;
  CHECK(is_feasible(found.assessment));
  CHECK(found.evaluations > 0);
  CHECK(found.x[0] == Approx(1).epsilon(1e-6));
}

}  // namespace camlaw::optim::hard_starts_test
