// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "optim/search/optimise.h"
#include "tests/optim/verdict/judged_problems.h"

namespace camlaw::optim::prices_test {

using namespace verdict_tests;

namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::cos;
using std::sin;

/// A problem as a function of one bound, and the multiplier of that bound.
struct Moved {
  const char* what;
  std::function<Problem(double bound)> problem;
  double bound;
  double gain;  ///< what relaxing by one brings, or of an equation the objective's rise; by hand
  std::function<double(const Assessment&)> multiplier;
  /// 1 where the objective's derivative by the bound equals the multiplier, -1 where it is
  /// opposite.
  double sign;
};

double of_limit(const Assessment& a) { return a.limits.at(0).multiplier; }
double of_x(const Assessment& a) { return a.variables.at(0).multiplier; }

enum class Kind { Upper, Lower, Equation };

/// "flow" x^2 + 30 y and an objective of other size, so that factors of scaling show.
Problem sloped(Sense sense, double a, double b, Kind kind, double bound) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = -40, .upper = 40, .start = 1},
                       {.name = "y", .lower = -0.5, .upper = 0.5, .start = 0.01}};
  const double way = sense == Sense::Minimize ? 1 : -1;
  problem.objectives = {
      {{"cost", "N",
        function({0, 1},
                 [=](const auto& u) {
                   return way * 250.0 * ((u[0] - a) * (u[0] - a) + 900.0 * (u[1] - b) * (u[1] - b));
                 })},
       sense,
       Part::Value,
       {}}};
  Constraint flow{.response = {"flow", "l",
                               function({0, 1}, [](const auto& u) { return u[0] + 30.0 * u[1]; })}};
  if (kind != Kind::Lower) flow.upper = bound;
  if (kind != Kind::Upper) flow.lower = bound;
  problem.constraints = {flow};
  return problem;
}

Problem boxed(Sense sense, Kind kind, double bound) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = -9, .upper = 9, .start = 0},
                       {.name = "y", .lower = -9, .upper = 9, .start = 0}};
  (kind == Kind::Lower ? problem.variables[0].lower : problem.variables[0].upper) = bound;
  const double way = sense == Sense::Minimize ? 1 : -1, towards = kind == Kind::Lower ? -12 : 12;
  problem.objectives = {{{"cost", "N",
                          function({0, 1},
                                   [=](const auto& u) {
                                     return way * 50.0 *
                                            ((u[0] - towards) * (u[0] - towards) + u[0] * u[1] +
                                             u[1] * u[1]);
                                   })},
                         sense,
                         Part::Value,
                         {}}};
  return problem;
}

std::vector<Moved> moved_bounds() {
  using enum Sense;
  std::vector<Moved> all;
  // 250 times the square of the distance of (x, 30 y) from (a, 30 b); "flow" is the sum of its
  // coordinates. From (a, 30 b) of sum s to a sum of c it is (s - c)^2 / 2: the optimum is 125
  // (s - c)^2 and its derivative by c -250 (s - c). With s - c = 4 or -4: 1000.
  const auto add = [&](const char* what, Sense sense, Kind kind, double c, double gain,
                       double sign) {
    all.push_back({what, [=](double bound) { return sloped(sense, 3, 0.1, kind, bound); }, c, gain,
                   of_limit, sign});
  };
  add("upper, minimise", Minimize, Kind::Upper, 2, 1000, -1);
  add("lower, minimise", Minimize, Kind::Lower, 10, 1000, 1);
  add("upper, maximise", Maximize, Kind::Upper, 2, 1000, 1);
  add("lower, maximise", Maximize, Kind::Lower, 10, 1000, -1);
  add("equation from below, minimise", Minimize, Kind::Equation, 2, -1000, 1);
  add("equation from above, minimise", Minimize, Kind::Equation, 10, 1000, 1);
  add("equation from below, maximise", Maximize, Kind::Equation, 2, 1000, 1);
  add("equation from above, maximise", Maximize, Kind::Equation, 10, -1000, 1);
  // 50 ((x -+ 12)^2 + x y + y^2), x at its bound b: y = -b/2, so 50 ((b -+ 12)^2 - b^2 / 4), of
  // derivative 50 (2 (b -+ 12) - b/2): at b = 4 for 12 50 (-16 - 2) = -900.
  const auto box = [&](const char* what, Sense sense, Kind kind, double b, double sign) {
    all.push_back(
        {what, [=](double bound) { return boxed(sense, kind, bound); }, b, 900, of_x, sign});
  };
  box("upper bound of a variable, minimise", Minimize, Kind::Upper, 4, -1);
  box("lower bound of a variable, minimise", Minimize, Kind::Lower, -4, 1);
  box("upper bound of a variable, maximise", Maximize, Kind::Upper, 4, 1);
  box("lower bound of a variable, maximise", Maximize, Kind::Lower, -4, -1);
  return all;
}

/// Least 7 x^2 + y^2 where "wave", x (2 + sin(a)) + y cos(2 a) / 10, keeps a bound over the cycle.
Problem waving(Sense sense, Kind kind, double bound) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = -5, .upper = 5, .start = 1},
                       {.name = "y", .lower = -5, .upper = 5, .start = 1}};
  const double way = sense == Sense::Minimize ? 1 : -1;
  problem.objectives = {
      {{"cost", "N",
        function({0, 1}, [=](const auto& u) { return way * (7.0 * u[0] * u[0] + u[1] * u[1]); })},
       sense,
       Part::Value,
       {}}};
  Constraint wave{
      .response = {"wave", "mm",
                   curve<Interval>({0, 1}, 0, 2 * kPi, [](const auto& u, const auto& angle) {
                     using T = std::remove_cvref_t<decltype(angle)>;
                     return u[0] * (constant<T>(2) + sin(angle)) +
                            u[1] * cos(angle + angle) / constant<T>(10);
                   })}};
  (kind == Kind::Lower ? wave.lower : wave.upper) = bound;
  problem.constraints = {wave};
  return problem;
}

/// Least highest of (x - a)^2 + y over a in [0, 4] where 3 y >= bound: x = 2, 4 + bound / 3.
Problem raised(double bound) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = -5, .upper = 5, .start = 1},
                       {.name = "y", .lower = -50, .upper = 50, .start = 10}};
  problem.objectives = {{{"cost", "N",
                          curve<Interval>({0, 1}, 0, 4,
                                          [](const auto& u, const auto& angle) {
                                            return (u[0] - angle) * (u[0] - angle) + u[1];
                                          })},
                         Sense::Minimize,
                         Part::Highest,
                         {}}};
  problem.constraints = {
      {.response = {"level", "mm", function({1}, [](const auto& u) { return 3.0 * u[0]; })},
       .lower = bound}};
  return problem;
}

std::vector<Moved> moved_over_cycle() {
  using enum Sense;
  std::vector<Moved> all;
  const auto add = [&](const char* what, Sense sense, Kind kind, double c, double sign) {
    all.push_back(
        {what, [=](double bound) { return waving(sense, kind, bound); }, c, kNan, of_limit, sign});
  };
  add("curve from below, minimise", Minimize, Kind::Lower, 2, 1);
  add("curve from above, minimise", Minimize, Kind::Upper, -2, -1);
  add("curve from below, maximise", Maximize, Kind::Lower, 2, -1);
  add("curve from above, maximise", Maximize, Kind::Upper, -2, 1);
  all.push_back({"limit under a peak", raised, 6, 1.0 / 3, of_limit, 1});
  return all;
}

/// Derivative of the optimum by the bound: central differences, extrapolated once.
double resolved_slope(const Moved& moved, double step) {
  const auto optimum = [&](double bound) {
    Problem problem = moved.problem(bound);
    for (Constraint& c : problem.constraints) c.tolerance = 1e-10;
    const Optimum found = optimise(problem);
    INFO(moved.what << ": " << found.found.assessment.reason);
    CHECK(found.found.assessment.verdict == Verdict::Certified);
    return found.found.assessment.objective.value;
  };
  const auto central = [&](double h) {
    return (optimum(moved.bound + h) - optimum(moved.bound - h)) / (2 * h);
  };
  return (4 * central(step / 2) - central(step)) / 3;
}

void check_multiplier(const Moved& moved) {
  INFO(moved.what);
  const Optimum found = optimise(moved.problem(moved.bound));
  REQUIRE(found.found.assessment.verdict == Verdict::Certified);
  const double multiplier = moved.multiplier(found.found.assessment);
  if (!std::isnan(moved.gain)) CHECK(multiplier == Approx(moved.gain).epsilon(1e-5));
  CHECK(moved.sign * multiplier == Approx(resolved_slope(moved, 0.05)).epsilon(1e-4));
}

}  // namespace

TEST_CASE("multipliers are what the optimum gains where a bound moves", "[verdict]") {
  for (const Moved& moved : moved_bounds()) check_multiplier(moved);
}

TEST_CASE("multipliers of limits over the cycle, and under a peak, too", "[verdict]") {
  for (const Moved& moved : moved_over_cycle()) check_multiplier(moved);
}

TEST_CASE("limits that do not hold the design have no multiplier", "[verdict]") {
  Problem problem = projection();
  problem.constraints.push_back(
      {.response = {"idle", "mm",
                    function(
                        {0}, [](const auto& u) { return u[0]; }, Shape::Linear)},
       .upper = 3});
  const Assessment a = judge(problem, {1.5, 0.5});
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.limits[1].multiplier == 0);
  CHECK(a.limits[1].margin == 1.5);
  CHECK(a.active == Names{"sum"});
  // Pushed the wrong way: the objective grows away from the limit that the design stands at.
  problem.constraints[0].lower = 2;
  problem.constraints[0].upper.reset();
  const Assessment turned = judge(problem, {1.5, 0.5});
  CHECK(turned.verdict == Verdict::Feasible);
  CHECK(turned.limits[0].multiplier == 0);
}

TEST_CASE("limits that depend on each other are certified with an infinite condition",
          "[verdict]") {
  Problem problem = projection();
  problem.constraints.push_back(
      {.response = {"double", "mm",
                    function(
                        {0, 1}, [](const auto& u) { return 2.0 * u[0] + 2.0 * u[1]; },
                        Shape::Linear)},
       .upper = 4});
  const Assessment a = judge(problem, {1.5, 0.5});
  CHECK(a.verdict == Verdict::Certified);
  CHECK(std::isinf(a.condition));
  CHECK(a.limits[0].multiplier + 2 * a.limits[1].multiplier == Approx(1).epsilon(1e-9));
}

}  // namespace camlaw::optim::prices_test
