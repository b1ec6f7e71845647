// SPDX-License-Identifier: MIT
// Lower bounds by dividing the box: what they claim against fine grids and known answers.
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "numerics/scalar/series.h"
#include "optim/search/interruptible.h"
#include "optim/search/optimise.h"
#include "tests/optim/verdict/judged_problems.h"
#include "tests/random_numbers.h"

namespace camlaw::optim::subdivision_test {
namespace {

using namespace verdict_tests;
using Slope = Series<Interval, 2>;

/// A polynomial a0 + a1 x + ... in one variable, Horner's scheme.
struct Polynomial {
  std::vector<double> a;
  template <class T>
  T operator()(const T& x) const {
    T sum = number<T>(a.back());
    for (std::size_t k = a.size() - 1; k-- > 0;) sum = sum * x + number<T>(a[k]);
    return sum;
  }
};

Polynomial wavy(testing::Random& random) {
  Polynomial p;
  for (int k = 0; k < 6; ++k) p.a.push_back(random(-3, 3));
  return p;
}

/// Least p(x) + q(y) + c x y on [-1.5, 1.5]^2 where r(x) + y <= level.
struct TwoVariables {
  Polynomial p, q, r;
  double coupling, level;

  template <class U>
  auto value(const U& u) const {
    using T = std::remove_cvref_t<decltype(u[0])>;
    return p(u[0]) + q(u[1]) + number<T>(coupling) * (u[0] * u[1]);
  }
  template <class U>
  auto limit(const U& u) const {
    return r(u[0]) + u[1];
  }
  Problem problem(double start) const {
    Problem result;
    result.variables = {{.name = "x", .lower = -1.5, .upper = 1.5, .start = start},
                        {.name = "y", .lower = -1.5, .upper = 1.5, .start = -start}};
    result.objectives = {least(function<Interval, Slope>(
        {0, 1}, [*this](const auto& u) { return value(u); }, Shape::General))};
    result.constraints = {
        {.response = {"limit", "mm",
                      function<Interval, Slope>(
                          {0, 1}, [*this](const auto& u) { return limit(u); }, Shape::General)},
         .upper = level}};
    return result;
  }
  /// The least of a fine grid.
  double least_of_grid() const {
    constexpr int kSteps = 600;
    double best = kInfinity;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; k <= kSteps; ++k) {
        const Point u{-1.5 + 3.0 * i / kSteps, -1.5 + 3.0 * k / kSteps};
        if (limit(u) <= level) best = std::min(best, value(u));
      }
    }
    return best;
  }
};

}  // namespace

TEST_CASE("dividing the box bounds what has several valleys, and finds the deepest",
          "[bound][subdivision]") {
  testing::Random random(8);
  int global = 0, compared = 0;
  for (int n = 0; n < 25; ++n) {
    const TwoVariables about{wavy(random), wavy(random), wavy(random), random(-2, 2),
                             random(-1, 2)};
    const double grid = about.least_of_grid();
    if (!std::isfinite(grid)) continue;
    ++compared;
    // From one start, which may lie in any valley.
    OptimiseOptions options;
    options.starts = 1;
    const Assessment a = optimise(about.problem(random(-1, 1)), options).found.assessment;
    INFO("problem " << n << ", grid " << grid << ", found " << a.objective.value << ": "
                    << a.reason);
    if (a.best_possible) CHECK(*a.best_possible <= grid + 1e-12 * std::abs(grid));
    if (!a.global) continue;
    ++global;
    CHECK(a.objective.value <= grid + 1e-5);
    CHECK(*a.best_possible == Approx(a.objective.value).epsilon(1e-5).margin(1e-5));
  }
  CHECK(compared >= 20);
  CHECK(global >= compared - 2);
}

TEST_CASE("the six-hump camel's valleys are equal, and no design is better", "[subdivision]") {
  // Dixon and Szegoe 1978: least -1.0316284535 at +-(0.0898420, -0.7126564).
  Problem problem;
  problem.variables = {{.name = "x", .lower = -3, .upper = 3, .start = 1.6},
                       {.name = "y", .lower = -2, .upper = 2, .start = -0.5}};
  problem.objectives = {least(function<Interval, Slope>({0, 1}, [](const auto& u) {
    using T = std::remove_cvref_t<decltype(u[0])>;
    const T xx = u[0] * u[0], yy = u[1] * u[1];
    const T slow = number<T>(4) - number<T>(2.1) * xx + xx * xx / number<T>(3);
    return slow * xx + u[0] * u[1] + number<T>(4) * (yy - number<T>(1)) * yy;
  }))};
  OptimiseOptions options;
  options.starts = 1;
  const Assessment a = optimise(problem, options).found.assessment;
  CHECK(a.objective.value == Approx(-1.0316284535).epsilon(1e-9));
  REQUIRE(a.global);
  CHECK(a.global->find("no design below -1.03162") == 0);
  CHECK(a.global->find("more than the tolerance") == std::string::npos);
  // A bound says no more than to a millionth, whatever the objective's tolerance.
  problem.objectives[0].tolerance = 1e-12;
  const Assessment strict = optimise(problem, options).found.assessment;
  REQUIRE(strict.global);
  CHECK(std::abs(strict.objective.value - *strict.best_possible) > 1e-12);
  CHECK(strict.global->find("more than the tolerance of 1e-12") != std::string::npos);
}

TEST_CASE("where ranges are not known nothing is called global", "[subdivision]") {
  // The same formula with and without ranges: a valley each at -1 and 1.02.
  const auto valleys = [](const auto& u) {
    using T = std::remove_cvref_t<decltype(u[0])>;
    const T both = (u[0] + number<T>(1)) * (u[0] - number<T>(1.02));
    return both * both + number<T>(0.1) * u[0];
  };
  Problem problem;
  problem.variables = {{.name = "x", .lower = -2, .upper = 2, .start = 1}};
  problem.objectives = {least(function<Interval>({0}, valleys))};
  const Scales about = scales(problem, problem.start());
  CHECK_FALSE(subdivided(problem, about, Point{1}));
  CHECK_FALSE(optimise(problem).found.assessment.global);
  problem.objectives = {least(function<Interval, Slope>({0}, valleys))};
  const auto division = subdivided(problem, about, Point{1});
  REQUIRE(division);
  REQUIRE(division->better);
  CHECK(division->better->front() < 0);
  CHECK(optimise(problem).found.assessment.global);
  // A side without an end, and more variables than are divided.
  problem.variables.front().upper = kInfinity;
  CHECK_FALSE(subdivided(problem, about, Point{1}));
}

TEST_CASE("what a division has shown when it is cut short still holds, and the answer says so",
          "[subdivision]") {
  int looks = 0, most = 0;
  std::atomic<bool> stop{false};
  const auto camel = [&](const auto& u) {
    using T = std::remove_cvref_t<decltype(u[0])>;
    if constexpr (std::is_same_v<T, Slope>) stop = ++looks > most;
    const T xx = u[0] * u[0], yy = u[1] * u[1];
    const T slow = number<T>(4) - number<T>(2.1) * xx + xx * xx / number<T>(3);
    return slow * xx + u[0] * u[1] + number<T>(4) * (yy - number<T>(1)) * yy;
  };
  Problem problem;
  problem.variables = {{.name = "x", .lower = -3, .upper = 3, .start = 1.6},
                       {.name = "y", .lower = -2, .upper = 2, .start = -0.5}};
  problem.objectives = {least(function<Interval, Slope>({0, 1}, camel))};
  const Point valley{0.0898420131, -0.7126564032};
  const Scales about = scales(problem, valley);
  // The functions of a search throw where its time is over.
  const Deadline deadline({}, &stop);
  const Problem guarded = interruptible(problem, deadline);
  double before = -kInfinity;
  for (const int looked : {200, 400, 800, 1600}) {
    looks = 0;
    most = looked;
    stop = false;
    const auto division = subdivided(guarded, about, valley);
    REQUIRE(division);
    CHECK(division->is_cut);
    CHECK_FALSE(division->better);
    CHECK(division->best_possible < -1.0316284535);
    CHECK(division->best_possible >= before);
    before = division->best_possible;
  }
  OptimiseOptions options;
  options.starts = 1;
  options.stop = &stop;
  const auto stopped_after = [&](int looked) {
    looks = 0;
    most = looked;
    stop = false;
    return optimise(problem, options).found.assessment;
  };
  const Assessment a = stopped_after(1600);
  CHECK(a.verdict == Verdict::Certified);
  CHECK_FALSE(a.global);
  CHECK(a.best_possible.value() < -1.0316284535);
  CHECK_THAT(a.reason, Catch::Contains("elsewhere was cut short: stopped"));
  // As soon as it has begun, where nothing has been shown yet.
  for (const int looked : {0, 1, 2}) {
    INFO(looked);
    const Assessment early = stopped_after(looked);
    CHECK_FALSE(early.global);
    CHECK_THAT(early.reason, Catch::Contains("cut short: stopped") || Catch::StartsWith("stopped"));
  }
}

}  // namespace camlaw::optim::subdivision_test
