// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::over_cycle_test {

using namespace search_tests;

namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::cos;
using std::sin;

/// x (1 + cos(angle) / 10) + a spike of height 1 and half width 0.002 deg at `place`, which no
/// sample meets: those of the search are 1.4 deg apart. Its tail slopes by 2 w^2 / d^3, 1e-4 at a
/// distance of 0.4 deg, less than the wave does: no sample there looks like a peak.
auto spiked(double place) {
  return [place](const auto& u, const auto& angle) {
    using T = std::remove_cvref_t<decltype(angle)>;
    const auto number = [](double c) { return constant<T>(c); };
    const T away = (angle - number(place)) / number(0.002);
    const T wave = cos(angle * number(std::acos(-1.0) / 180));
    return u[0] * (number(1) + number(0.1) * wave) + number(1) / (number(1) + away * away);
  };
}

}  // namespace

TEST_CASE("a limit that breaks only between the samples is found by the proof and respected",
          "[optimise]") {
  constexpr double kPlace = 100.123, kLimit = 3;
  Problem problem;
  problem.variables = {variable("x", 0, 10, 1)};
  problem.objectives = {most(linear({0}, [](const auto& u) { return u[0]; }))};
  problem.constraints = {
      {.response = {"stress", "MPa", curve<Interval>({0}, 0, 360, spiked(kPlace), Shape::Linear)},
       .upper = kLimit}};
  const Found found = optimise(problem).found;
  REQUIRE(found.x.size() == 1);
  const LimitReport& stress = found.assessment.limits.at(0);
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(stress.proved);
  CHECK(std::abs(stress.margin) <= stress.tolerance);
  REQUIRE(stress.worst_angle);
  CHECK(*stress.worst_angle == Approx(kPlace).margin(1e-4));
  // Without the spike x would be 3 / 1.1 = 2.73. With it x (1 + cos(100.123 deg) / 10) = 2, but for
  // 1e-11, by which the wave moves the top: its slope is 0.0035 a degree.
  const double wave = 1 + 0.1 * std::cos(kPlace * std::acos(-1.0) / 180);
  CHECK(found.x[0] == Approx(2 / wave).epsilon(2e-6));
  CHECK(found.x[0] * wave + 1 <= kLimit + stress.tolerance);
  CHECK(stress.multiplier == Approx(1 / wave).epsilon(1e-6));
}

TEST_CASE("a limit that no design meets between the samples is not called met", "[optimise]") {
  // The spike alone is higher than 0.5, whatever x >= 0 is.
  Problem problem;
  problem.variables = {variable("x", 0, 10, 1)};
  problem.objectives = {most(linear({0}, [](const auto& u) { return u[0]; }))};
  problem.constraints = {
      {.response = {"stress", "MPa", curve<Interval>({0}, 0, 360, spiked(100.123), Shape::Linear)},
       .upper = 0.5}};
  const Found found = optimise(problem).found;
  const Assessment& a = found.assessment;
  CHECK_FALSE(is_feasible(a));
  CHECK(a.verdict == Verdict::Infeasible);
  CHECK(a.blamed == Names{"stress", "lower bound of x"});
  CHECK(a.limits.at(0).value == Approx(1).epsilon(1e-6));
  CHECK(*a.limits.at(0).worst_angle == Approx(100.123).margin(1e-4));
  CHECK(found.x.at(0) == Approx(0).margin(1e-6));
}

namespace {

/// Of two options the most x, with the spike in the first and none in the second, below `limit`;
/// the second takes no x above `most`.
ProblemSpace spike_or_none(double limit, double second_most) {
  ProblemSpace space;
  space.choices = {{"form", "", {"spiked", "plain"}, {}}};
  space.problem = [=](const std::vector<std::size_t>& options) {
    const bool is_spiked = options[0] == 0;
    const auto plain = [](const auto& u, const auto&) { return u[0]; };
    Problem problem;
    problem.variables = {variable("x", 0, is_spiked ? 10 : second_most, 1)};
    problem.objectives = {most(linear({0}, [](const auto& u) { return u[0]; }))};
    const auto stress = is_spiked ? curve<Interval>({0}, 0, 360, spiked(100.123), Shape::Linear)
                                  : curve<Interval>({0}, 0, 360, plain, Shape::Linear);
    problem.constraints = {{.response = {"stress", "MPa", stress}, .upper = limit}};
    return problem;
  };
  return space;
}

}  // namespace

TEST_CASE("where a proof leaves the best option no design, the next best is the answer",
          "[optimise]") {
  // The spike alone is higher than 0.5. Without a proof the first option has x = 0.5 / 1.1.
  const Optimum optimum = optimise(spike_or_none(0.5, 0.25));
  const Assessment& a = optimum.found.assessment;
  CHECK(optimum.options == std::vector<std::size_t>{1});
  CHECK(optimum.found.x.at(0) == Approx(0.25).epsilon(1e-9));
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global);
  REQUIRE(optimum.parts.size() == 2);
  CHECK(optimum.parts[0].verdict == Verdict::Infeasible);
  CHECK(optimum.parts[0].active == Names{"stress", "lower bound of x"});
}

TEST_CASE("where a proof leaves the best option less than the next best, that is the answer",
          "[optimise]") {
  // Without a proof the first option has x = 3 / 1.1 = 2.73, with it 2.0 (see above).
  for (const double second : {2.5, 1.5}) {
    const Optimum optimum = optimise(spike_or_none(3, second));
    const std::size_t best = second > 2.1 ? 1 : 0;
    CHECK(optimum.options == std::vector<std::size_t>{best});
    const double wave = 1 + 0.1 * std::cos(100.123 * std::acos(-1.0) / 180);
    CHECK(optimum.found.x.at(0) == Approx(best == 1 ? second : 2 / wave).epsilon(2e-6));
    CHECK(optimum.found.assessment.verdict == Verdict::Certified);
    REQUIRE(optimum.parts.size() == 2);
    if (best == 1) CHECK(optimum.parts[0].objective == Approx(2 / wave).epsilon(2e-6));
  }
}

TEST_CASE("where proofs leave no option a design, all are infeasible", "[optimise]") {
  ProblemSpace space = spike_or_none(0.5, 0.25);
  const auto first = space.problem;
  space.problem = [first](const std::vector<std::size_t>&) { return first({0}); };
  const Optimum optimum = optimise(space);
  CHECK(optimum.found.assessment.verdict == Verdict::Infeasible);
  CHECK(contains(optimum.found.assessment.reason, "none of the 2 combinations meets the limits"));
  CHECK(optimum.found.assessment.blamed == Names{"stress", "lower bound of x"});
}

TEST_CASE("a peak between the samples counts in the objective too", "[optimise]") {
  // Least highest of x (1 + cos / 10) + spike + 4 (x - 2)^2 over the cycle: about the spike 1 +
  // wave x + 4 (x - 2)^2, least at x = 2 - wave / 8; elsewhere at most 1.1 x + 4 (x - 2)^2.
  constexpr double kPlace = 100.123;
  Problem problem;
  problem.variables = {variable("x", 0, 10, 1)};
  const auto f = [](const auto& u, const auto& angle) {
    using T = std::remove_cvref_t<decltype(angle)>;
    const T off = u[0] - constant<T>(2);
    return spiked(kPlace)(u, angle) + constant<T>(4) * off * off;
  };
  problem.objectives = {{{"stress", "MPa", curve<Interval>({0}, 0, 360, f, Shape::Convex)},
                         Sense::Minimize,
                         Part::Highest,
                         {}}};
  const Found found = optimise(problem).found;
  const double wave = 1 + 0.1 * std::cos(kPlace * std::acos(-1.0) / 180);
  const double x = 2 - wave / 8, peak = 1 + wave * x + wave * wave / 16;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(x).epsilon(1e-5));
  CHECK(found.assessment.objective.value == Approx(peak).epsilon(1e-9));
  CHECK(*found.assessment.objective.angle == Approx(kPlace).margin(1e-4));
  CHECK(found.assessment.objective.proved.upper >= peak - 1e-6);
}

TEST_CASE("the line nearest to a cube is Chebyshev's", "[optimise]") {
  // a^3 - 3 a / 4 = T3(a) / 4 on [-1, 1] takes 1/4 and -1/4 four times in turn, at -1, -1/2, 1/2,
  // 1: no line comes nearer (Chebyshev's alternation).
  Problem problem;
  problem.variables = {variable("offset", -2, 2, 0.3), variable("slope", -2, 2, -0.4)};
  problem.objectives = {{{"error", "mm",
                          curve<Interval>(
                              {0, 1}, -1, 1,
                              [](const auto& u, const auto& angle) {
                                return angle * angle * angle - u[0] - u[1] * angle;
                              },
                              Shape::Linear)},
                         Sense::Minimize,
                         Part::Magnitude,
                         {}}};
  const Found found = optimise(problem).found;
  const Assessment& a = found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global);
  CHECK(a.objective.value == Approx(0.25).epsilon(1e-6));
  CHECK(found.x[0] == Approx(0).margin(1e-6));
  CHECK(found.x[1] == Approx(0.75).epsilon(1e-6));
  CHECK(a.objective.proved.lower <= 0.25);
  CHECK(a.objective.proved.upper >= 0.25);
  CHECK(a.objective.proved.upper <= 0.25 + 1e-6);
}

TEST_CASE("the highest value minimised and the lowest maximised", "[optimise]") {
  // (a - x)^2 over a in [0, 3], least highest: x = 3/2, 9/4, both ends. With -(a - x)^2 the lowest.
  Problem problem;
  problem.variables = {variable("x", -10, 10, -3)};
  const auto f = [](double sign) {
    return [sign](const auto& u, const auto& angle) {
      using T = std::remove_cvref_t<decltype(angle)>;
      const T away = angle - u[0];
      return constant<T>(sign) * away * away;
    };
  };
  problem.objectives = {{{"gap", "mm", curve<Interval>({0}, 0, 3, f(1), Shape::Convex)},
                         Sense::Minimize,
                         Part::Highest,
                         {}}};
  const Found highest = optimise(problem).found;
  CHECK(highest.assessment.verdict == Verdict::Certified);
  CHECK(highest.x[0] == Approx(1.5).epsilon(1e-6));
  CHECK(highest.assessment.objective.value == Approx(2.25).epsilon(1e-6));
  problem.objectives = {{{"gap", "mm", curve<Interval>({0}, 0, 3, f(-1), Shape::Concave)},
                         Sense::Maximize,
                         Part::Lowest,
                         {}}};
  const Found lowest = optimise(problem).found;
  CHECK(lowest.assessment.verdict == Verdict::Certified);
  CHECK(lowest.x[0] == Approx(1.5).epsilon(1e-6));
  CHECK(lowest.assessment.objective.value == Approx(-2.25).epsilon(1e-6));
}

TEST_CASE("a limit over the cycle on a smooth objective", "[optimise]") {
  // Most y where x sin(a) + y <= 2 over a whole turn: |x| + y <= 2, and x >= 1/2: y = 3/2.
  Problem problem;
  problem.variables = {variable("x", 0.5, 10, 3), variable("y", -10, 10)};
  problem.objectives = {most(linear({1}, [](const auto& u) { return u[0]; }))};
  problem.constraints = {
      {.response = {"wave", "mm",
                    curve<Interval>(
                        {0, 1}, 0, 7,
                        [](const auto& u, const auto& angle) { return u[0] * sin(angle) + u[1]; },
                        Shape::Linear)},
       .upper = 2}};
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[0] == Approx(0.5).epsilon(1e-6));
  CHECK(found.x[1] == Approx(1.5).epsilon(1e-6));
  CHECK(found.assessment.limits[0].multiplier == Approx(1).epsilon(1e-6));
  CHECK(found.assessment.variables[0].multiplier == Approx(1).epsilon(1e-6));
}

}  // namespace camlaw::optim::over_cycle_test
