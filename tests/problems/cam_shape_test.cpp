// SPDX-License-Identifier: MIT
#include "problems/published/cam_shape/cam_shape.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "optim/problem/check_derivatives.h"
#include "optim/problem/starts.h"
#include "optim/search/exchange.h"
#include "optim/verdict/verdict.h"
#include "problems/published/cam_shape/reproduction.h"
#include "problems/published/cam_shape/solve.h"

namespace camlaw::problems::cam_shape_test {
namespace {

using Catch::Matchers::Contains;
using Point = std::vector<double>;
constexpr double kPi = std::numbers::pi;

double opening(const Point& r) {
  return kPi / static_cast<double>(r.size()) * std::accumulate(r.begin(), r.end(), 0.0);
}

/// Neither feasible nor at a bound.
Point random_radii(int n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Point r;
  for (int i = 1; i <= n; ++i) {
    r.push_back(std::uniform_real_distribution<double>(1.1, 1.9)(random));
  }
  return r;
}

/// The recursion's optimum with every row eased: convexity over d^2 by `convexity`, slope over d by
/// `slope`. In radii, from the rows as published: not the library's recursion.
double eased_optimum(int n, double convexity, double slope) {
  const double d = 2 * kPi / (5 * (n + 1.0));
  Point r{1, 1};
  for (int i = 1; i <= n; ++i) {
    const double a = r[r.size() - 2], b = r.back(), slack = convexity * d * d;
    const double divisor = 2 * a * std::cos(d) - b;
    const double convex = divisor > 0 ? (a * b + slack) / divisor : 2;
    r.push_back(std::min({convex, b + (1.5 + slope) * d, 2.0}));
  }
  return opening({r.begin() + 2, r.end()});
}

/// Grids that close in on the best feasible point: no derivatives, no rows but the published ones.
double best_on_grids_of_three() {
  constexpr int kSteps = 12, kRounds = 90;
  Point best{1, 1, 1};
  double most = -1, width = 0.5;
  Point center{1.5, 1.5, 1.5};
  for (int round = 0; round < kRounds; ++round, width *= 0.85) {
    for (int i = 0; i < (2 * kSteps + 1) * (2 * kSteps + 1) * (2 * kSteps + 1); ++i) {
      Point r = center;
      for (int k = 0, rest = i; k < 3; ++k, rest /= 2 * kSteps + 1) {
        r[static_cast<std::size_t>(k)] += width * (rest % (2 * kSteps + 1) - kSteps) / kSteps;
      }
      if (opening(r) <= most || cam_shape_published_violation(r) > 0) continue;
      most = opening(r);
      best = r;
    }
    center = best;
  }
  return most;
}

optim::Assessment judge(const optim::Problem& problem, const Point& r) {
  return optim::assess(problem, optim::scales(problem, problem.start()), r, true);
}

const Point& default_answer() {
  static const Point r = cam_shape_by_ipopt_defaults(1000);
  return r;
}

}  // namespace

TEST_CASE("the recursion gives the known optima", "[cam-shape]") {
  // As the issue states them, to nine decimals.
  CHECK(std::abs(cam_shape_optimum(100) - 4.284147122) <= 6e-10);
  CHECK(std::abs(cam_shape_optimum(200) - 4.278500233) <= 6e-10);
  CHECK(std::abs(cam_shape_optimum(400) - 4.275688479) <= 6e-10);
  CHECK(std::abs(cam_shape_optimum(800) - 4.274274142) <= 6e-10);
  CHECK(std::abs(cam_shape_optimum(1000) - 4.273991251) <= 6e-10);
}

TEST_CASE("the optimum tends to the continuous cam's, ten times nearer for ten times the points",
          "[cam-shape]") {
  CHECK(cam_shape_limit() == Approx(4.2728604777).epsilon(1e-11));
  const double coarse = cam_shape_optimum(10000) - cam_shape_limit();
  const double fine = cam_shape_optimum(100000) - cam_shape_limit();
  CHECK(coarse == Approx(1.1312e-4).epsilon(1e-3));
  CHECK(coarse / fine == Approx(10).epsilon(1e-3));
}

TEST_CASE("the recursion's cam is feasible and ends at the largest radius", "[cam-shape]") {
  for (int n = 3; n <= 100000; n = n < 300 ? n + 1 : n * 7 / 5) {
    const Point r = cam_shape_radii(n);
    INFO(n);
    CHECK(r.size() == static_cast<std::size_t>(n));
    CHECK(cam_shape_published_violation(r) <= 1e-14);
    CHECK(std::is_sorted(r.begin(), r.end()));
    CHECK(2 - r.back() <= 1.5 * cam_shape_angle(n));
  }
}

TEST_CASE("grids that close in on three radii find the recursion's optimum", "[cam-shape]") {
  const double found = best_on_grids_of_three();
  CHECK(found <= cam_shape_optimum(3));
  CHECK(found == Approx(cam_shape_optimum(3)).epsilon(1e-6));
}

TEST_CASE("SLSQP finds nothing better than the recursion from any of many starts", "[cam-shape]") {
  const optim::Solver& slsqp = optim::find_solver("slsqp");
  for (const int n : {3, 4, 5, 6}) {
    const optim::Problem problem = cam_shape(n);
    const optim::Scales scales = optim::scales(problem, problem.start());
    double most = 0;
    for (const Point& start : optim::starts(problem, 40, 1)) {
      const Point r = optim::exchange(problem, scales, start, slsqp, {}).x;
      if (cam_shape_published_violation(r) <= 1e-9) most = std::max(most, opening(r));
    }
    INFO(n);
    CHECK(most == Approx(cam_shape_optimum(n)).epsilon(1e-7));
  }
}

TEST_CASE("the problem is well posed and knows its answer", "[cam-shape]") {
  for (const int n : {3, 4, 50}) {
    const optim::Problem problem = cam_shape(n);
    CHECK_NOTHROW(problem.check());
    CHECK(problem.variables.size() == static_cast<std::size_t>(n));
    CHECK(problem.constraints.size() == static_cast<std::size_t>(2 * n + 3));
    REQUIRE(problem.known);
    CHECK(problem.known->objective == opening(problem.known->x));
    CHECK(problem.constraints[0].response.name == "convexity 0");
    CHECK(problem.constraints.back().response.name == "slope " + std::to_string(n));
  }
}

TEST_CASE("rows are the published ones over the angle's square and the angle", "[cam-shape]") {
  constexpr int n = 6;
  const double d = cam_shape_angle(n);
  const optim::Problem problem = cam_shape(n);
  const Point radii = random_radii(n, 1);
  Point r{1, 1};  // r_{-1} .. r_{n+2}
  r.insert(r.end(), radii.begin(), radii.end());
  r.insert(r.end(), {2, radii.back()});
  for (std::size_t i = 0; i <= n + 1; ++i) {
    const double a = r[i], b = r[i + 1], c = r[i + 2];
    const auto& convexity = problem.constraints[i];
    INFO(convexity.response.name);
    CHECK(convexity.response.function().value(radii) ==
          Approx((2 * a * c * std::cos(d) - b * (a + c)) / (d * d)).epsilon(1e-13));
    if (i > n) continue;
    const auto& slope = problem.constraints[n + 2 + i];
    CHECK(slope.response.function().value(radii) == Approx((c - b) / d).epsilon(1e-14));
  }
}

TEST_CASE("the published violation is that of the worst row or bound", "[cam-shape]") {
  Point r = cam_shape_radii(10);
  const double d = cam_shape_angle(10);
  CHECK(cam_shape_published_violation(Point(10, 1.0)) == Approx(4 * std::cos(d) - 3));  // row n
  CHECK(cam_shape_published_violation(Point(10, 2.5)) >= 1.5 - 1.5 * d);
  r[0] += 1e-3;  // row 0: 2 r_1 cos d - (1 + r_1); row 1 moves more
  CHECK(cam_shape_published_violation(r) >= (2 * std::cos(d) - 1) * 1e-3 * (1 - 1e-9));
  CHECK(cam_shape_published_violation(r) <= 4e-3);
}

TEST_CASE("derivatives of all rows agree with differences", "[cam-shape]") {
  for (const int n : {3, 5}) {
    const optim::DerivativeCheck check = optim::check_derivatives(cam_shape(n), random_radii(n, 2));
    INFO(n << ": " << check.worst.response << " by " << check.worst.variable);
    CHECK(check.entries > 0);
    CHECK(check.agrees);
    CHECK(check.shapes.empty());
  }
}

TEST_CASE("cam-shape enclosures hold the value and are narrow", "[cam-shape]") {
  const optim::Problem problem = cam_shape(5);
  const Point r = random_radii(5, 3);
  std::vector<optim::Function> functions{problem.objective().response.function()};
  for (const auto& c : problem.constraints) functions.push_back(c.response.function());
  for (const optim::Function& f : functions) {
    const auto [lower, upper] = f.enclose(r);
    CHECK(lower <= f.value(r));
    CHECK(f.value(r) <= upper);
    CHECK(upper - lower <= 1e-12 * (1 + std::abs(f.value(r))));
  }
}

TEST_CASE("what all tolerances together allow is less than 1e-7 of the optimum", "[cam-shape]") {
  for (const int n : {10, 100, 1000, 10000}) {
    const optim::Problem problem = cam_shape(n);
    const double convexity = *problem.constraints.front().tolerance;
    const double slope = *problem.constraints.back().tolerance;
    const double gain = eased_optimum(n, convexity, slope) / cam_shape_optimum(n) - 1;
    INFO(n);
    CHECK(gain > 0);
    CHECK(gain < 1e-7);
  }
}

TEST_CASE("The true optimum is found, and the verdict certifies it", "[cam-shape]") {
  for (const int n : {3, 10, 100, 400, 1000}) {
    const CamShapeCase found = solve_cam_shape(n);
    INFO(n << ": " << found.reason);
    CHECK(found.n == n);
    CHECK(found.verdict == "certified optimum");
    CHECK(found.true_optimum == cam_shape_optimum(n));
    CHECK(found.objective == Approx(found.true_optimum).epsilon(1e-7));
    CHECK(found.max_violation <= 1e-10);
    if (n > 30) CHECK(found.iterations > 0);  // slsqp, which fewer variables take, counts none
    CHECK(found.wall_s > 0);
    CHECK(found.printed.has_value() == (n >= 100));
  }
  CHECK(*solve_cam_shape(100).printed == 4.2841);
}

TEST_CASE("A cam of a hundred thousand radii is found to twelve digits and certified",
          "[cam-shape][heavy]") {
  const CamShapeCase found = solve_cam_shape(kMostCamShape);
  INFO(found.reason);
  CHECK(found.verdict == "certified optimum");
  CHECK(found.objective == Approx(found.true_optimum).epsilon(1e-12));
  CHECK(found.max_violation <= 1e-14);
  CHECK(found.iterations < 10);
}

TEST_CASE("Ipopt's default answer to the published rows is too good, and is refused",
          "[cam-shape]") {
  const Point& r = default_answer();
  CHECK(opening(r) == Approx(4.279065).epsilon(1e-6));
  // Row by row it is off by no more than 1e-8: what it was allowed.
  CHECK(cam_shape_published_violation(r) <= 1.6e-8);
  const optim::Problem problem = cam_shape(1000);
  const optim::Assessment verdict = judge(problem, r);
  CHECK(verdict.verdict == optim::Verdict::Failed);
  CHECK_FALSE(optim::is_feasible(verdict));
  CHECK(optim::worst_violation(verdict.limits) > 1e4);
  CHECK_THAT(verdict.reason, Contains("convexity"));
}

TEST_CASE("rows eased by 1e-8 explain the answer that Ipopt gives by default", "[cam-shape]") {
  const double d = cam_shape_angle(1000);
  CHECK(opening(default_answer()) ==
        Approx(eased_optimum(1000, 1e-8 / (d * d), 1e-8 / d)).epsilon(2e-6));
}

TEST_CASE("the recursion's own cam is certified", "[cam-shape]") {
  const optim::Problem problem = cam_shape(1000);
  CHECK(judge(problem, problem.known->x).verdict == optim::Verdict::Certified);
}

TEST_CASE("every printed cam-shape value is reproduced or explained", "[cam-shape][heavy]") {
  const SystemReproduction result = reproduce_cam_shape();
  CHECK(result.system == "cam-shape");
  REQUIRE(result.values.size() == 5);
  CHECK(result.reproduced == 4);
  CHECK(result.explained == 1);
  const ReproducedValue& suite = result.values.back();
  CHECK(suite.printed.number.value == 4.2791);
  CHECK(suite.verdict == optim::Finding::Explained);
  CHECK(suite.stated_value == Approx(4.273991251).epsilon(1e-7));
  CHECK(suite.explained_value == Approx(4.279065).epsilon(1e-6));
  REQUIRE(suite.causes.size() == 1);
  CHECK_THAT(suite.causes.front(), Contains("widened by 1e-8"));
}

TEST_CASE("a bad number of points is refused by name", "[cam-shape]") {
  for (const int n : {-1, 0, 2, 100001}) {
    const auto named = Contains("n = " + std::to_string(n) + " is outside 3 .. 100000");
    CHECK_THROWS_WITH(cam_shape(n), named);
    CHECK_THROWS_WITH(solve_cam_shape(n), named);
    CHECK_THROWS_WITH(cam_shape_optimum(n), named);
    CHECK_THROWS_WITH(cam_shape_by_ipopt_defaults(n), named);
  }
}

}  // namespace camlaw::problems::cam_shape_test
