// SPDX-License-Identifier: MIT
// Objectives that change by orders of magnitude over the box: what counts as their optimum.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "numerics/scalar/series.h"
#include "optim/search/optimise.h"
#include "tests/optim/verdict/judged_problems.h"

namespace camlaw::optim::steep_objective_test {
namespace {

using namespace verdict_tests;
using std::cos, std::exp, std::log, std::sin;
using Slope = Series<Interval, 2>;

struct Steep {
  const char* text;
  Problem problem;
  double best;
};

/// 2 cosh(rate x).
template <class T>
T bowl(const T& x, double rate) {
  return exp(number<T>(rate) * x) + exp(number<T>(-rate) * x);
}

template <class F>
Steep steep(const char* text, Sense sense, double lower, double upper, double start, F f,
            double best, Shape shape = Shape::General) {
  const Function of = function<Interval, Slope>(
      {0}, [f](const auto& u) { return f(u[0]); }, shape);
  Problem problem;
  problem.variables = {{.name = "q", .lower = lower, .upper = upper, .start = start}};
  problem.objectives = {sense == Sense::Minimize ? least(of) : most(of)};
  return {text, problem, best};
}

/// The least of a fine grid, as if it were refined to the last digit.
double least_of(const std::function<double(double)>& f, double lower, double upper) {
  constexpr int kSteps = 20000;
  double best = lower, step = (upper - lower) / kSteps;
  for (int i = 0; i <= kSteps; ++i) {
    const double q = lower + step * i;
    if (f(q) < f(best)) best = q;
  }
  for (; step > 1e-12 * (upper - lower); step *= 0.5) {
    for (const double q : {best - step, best + step}) {
      if (q >= lower && q <= upper && f(q) < f(best)) best = q;
    }
  }
  return f(best);
}

std::vector<Steep> cases() {
  const auto waves = []<class T>(const T& q) {
    return bowl(q - number<T>(1), 10) * (number<T>(2) + cos(q));
  };
  const auto slopes = []<class T>(const T& q) {
    return exp(number<T>(6.6) * (q - number<T>(3.644))) +
           exp(number<T>(-36.2) * (q - number<T>(2.593)));
  };
  return {steep(
              "exp(6 q^2)", Sense::Minimize, 0, 5, 5,
              []<class T>(const T& q) { return exp(number<T>(6) * q * q); }, 1),
          // At q = 1/e.
          steep(
              "q^(20 q)", Sense::Minimize, 0.1, 5, 5,
              []<class T>(const T& q) { return exp(number<T>(20) * q * log(q)); },
              std::exp(-20 / std::exp(1))),
          steep("2 cosh(10 (q - 1)) (2 + cos q)", Sense::Minimize, 0.1, 20, 20, waves,
                least_of(waves, 0.1, 20)),
          steep(
              "-exp(40 q) (2 + sin q)", Sense::Maximize, 0, 5, 5,
              []<class T>(const T& q) { return -exp(number<T>(40) * q) * (number<T>(2) + sin(q)); },
              -2),
          steep(
              "2 cosh(40 (q - 1))", Sense::Minimize, 0, 3, 2.5,
              []<class T>(const T& q) { return bowl(q - number<T>(1), 40); }, 2),
          // Convex by its shape: no box is divided, and one start is enough.
          steep("exp(6.6 (q - 3.644)) + exp(-36.2 (q - 2.593))", Sense::Minimize, 0.1, 4.3, 0.1,
                slopes, least_of(slopes, 0.1, 4.3), Shape::Convex)};
}

}  // namespace

TEST_CASE("of a steep function the optimum is found, and global to a small share of its value",
          "[bound][scales]") {
  for (const Steep& c : cases()) {
    INFO(c.text);
    const Assessment a = optimise(c.problem).found.assessment;
    CHECK(a.global);
    CHECK(std::abs(a.objective.value - c.best) <= a.objective.tolerance);
    CHECK(a.objective.tolerance <= 1e-5 * std::abs(c.best));
    REQUIRE(a.best_possible);
    CHECK(std::abs(*a.best_possible - c.best) <= 1e-5 * std::abs(c.best));
  }
}

TEST_CASE("an answer is judged in the scales of where the last search led", "[bound][scales]") {
  // From the start exp(-38.7 (q - 2.673)) falls by 43 orders of magnitude; one search is not
  // enough. The parts of q and r are least apart: at q = 2.84, and at r^4 = 32.124 / 3.
  const auto f = []<class U>(const U& u) {
    using T = std::remove_cvref_t<decltype(u[0])>;
    return exp(number<T>(7.6) * (u[0] - number<T>(3.884))) +
           exp(number<T>(-38.7) * (u[0] - number<T>(2.673))) + number<T>(32.124) / u[1] +
           u[1] * u[1] * u[1];
  };
  Problem problem;
  problem.variables = {{.name = "q", .lower = 0.1, .upper = 4.8, .start = 0.1},
                       {.name = "r", .lower = 0.1, .upper = 1.7, .start = 0.121}};
  problem.objectives = {least(function<Interval, Slope>({0, 1}, f, Shape::Convex))};
  const double r = std::min(1.7, std::pow(32.124 / 3, 0.25));
  const double best = least_of([&](double q) { return f(Point{q, r}); }, 0.1, 4.8);
  const Assessment a = optimise(problem).found.assessment;
  CHECK(a.objective.value == Approx(best).epsilon(1e-7));
  CHECK(a.objective.tolerance <= 1e-5 * best);
}

TEST_CASE("no design on the slope of a steep function is an optimum", "[verdict][scales]") {
  for (const Steep& c : cases()) {
    for (const double share : {0.3, 0.5, 0.9}) {
      const Variable& v = c.problem.variables.front();
      const Point x{v.lower + share * (v.upper - v.lower)};
      const Scales there = scales(c.problem, x);
      INFO(c.text << " at " << x[0]);
      CHECK(assess(c.problem, there, x, true).verdict == Verdict::Feasible);
      const auto division = subdivided(c.problem, there, x);
      REQUIRE(division);
      CHECK(division->better);
    }
  }
}

TEST_CASE("a least value of 0 counts by what changes make of it", "[scales]") {
  // About 0 the slopes of x^2 are those of the distance; a value of 0 has no size of its own.
  Problem problem;
  problem.variables = {{.name = "x", .lower = -2, .upper = 6, .start = 3}};
  problem.objectives = {least(function<Interval, Slope>(
      {0}, [](const auto& u) { return square(u[0]); }, Shape::General))};
  const Scales s = scales(problem, Point{0});
  CHECK(s.objective_typical > 0.1);
  CHECK(s.objective_typical < 10);
  CHECK(s.objective_tolerance == Approx(1e-11 * s.objective_typical));
  const Assessment a = optimise(problem).found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global);
  CHECK(a.objective.value <= s.objective_tolerance);
}

}  // namespace camlaw::optim::steep_objective_test
