// SPDX-License-Identifier: MIT
// Lower bounds: what no design is better than, judged by answers that are known otherwise.
#include <catch2/catch.hpp>
#include <cmath>

#include "optim/search/optimise.h"
#include "tests/optim/verdict/judged_problems.h"
#include "tests/random_numbers.h"

namespace camlaw::optim::dual_bound_test {
namespace {

// Of plain numbers; those of other scalars are found by their arguments.
using std::exp;
using std::sin;

using namespace verdict_tests;

/// Least a x + b y where three straight limits leave a triangle about the origin.
Problem triangle(double a, double b, const std::vector<Point>& normals) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = -50, .upper = 50, .start = 0},
                       {.name = "y", .lower = -50, .upper = 50, .start = 0}};
  problem.objectives = {least(function<Interval>(
      {0, 1}, [=](const auto& u) { return a * u[0] + b * u[1]; }, Shape::Linear))};
  for (const Point& n : normals) {
    problem.constraints.push_back(
        {.response = {"side", "mm",
                      function<Interval>(
                          {0, 1}, [=](const auto& u) { return n[0] * u[0] + n[1] * u[1]; },
                          Shape::Linear)},
         .upper = n[2]});
  }
  return problem;
}

/// The least of a x + b y over the corners of what sides and box leave.
double least_corner(double a, double b, std::vector<Point> normals) {
  double best = kInfinity;
  for (const Point& side : {Point{1, 0, 50}, {-1, 0, 50}, {0, 1, 50}, {0, -1, 50}}) {
    normals.push_back(side);
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Point &p = normals[i], &q = normals[k];
      const double det = p[0] * q[1] - p[1] * q[0];
      if (std::abs(det) < 1e-9) continue;
      const double x = (p[2] * q[1] - p[1] * q[2]) / det, y = (p[0] * q[2] - p[2] * q[0]) / det;
      bool inside = true;
      for (const Point& n : normals) inside = inside && n[0] * x + n[1] * y <= n[2] + 1e-12;
      if (inside) best = std::min(best, a * x + b * y);
    }
  }
  return best;
}

}  // namespace

TEST_CASE("the bound of a linear problem is its least corner, and never above it", "[bound]") {
  testing::Random random(17);
  int compared = 0;
  for (int n = 0; n < 40; ++n) {
    std::vector<Point> normals;
    for (int side = 0; side < 3; ++side) {
      const double angle = 2 * kPi * (side + random(0, 0.8)) / 3;
      normals.push_back({std::cos(angle), std::sin(angle), random(0.2, 3)});
    }
    const double a = random(-2, 2), b = random(-2, 2);
    const double corner = least_corner(a, b, normals);
    compared += std::isfinite(corner);
    const Assessment found = optimise(triangle(a, b, normals)).found.assessment;
    CHECK(found.verdict == Verdict::Certified);
    CHECK(found.global);
    REQUIRE(found.best_possible);
    CHECK(*found.best_possible <= corner + 1e-12 * std::abs(corner));
    CHECK(*found.best_possible == Approx(corner).epsilon(1e-6).margin(1e-7));
  }
  CHECK(compared == 40);
}

TEST_CASE("away from the optimum the bound is below it, however wrong the multipliers", "[bound]") {
  // projection(): the optimum is 0.5.
  testing::Random random(4);
  const Problem problem = projection();
  for (int n = 0; n < 50; ++n) {
    const double x = random(0, 2);
    const Assessment a = judge(problem, {x, random(0, 2 - x)});
    if (a.best_possible) CHECK(*a.best_possible <= 0.5 + 1e-12);
  }
  CHECK(*judge(problem, {1.5, 0.5}).best_possible == Approx(0.5).epsilon(1e-9));
}

TEST_CASE("a quotient of linear functions is bounded by its slopes", "[bound]") {
  // Least (x + 2 y + 1) / (x + 4) where x y-box [0, 3]^2 and (y + 1) / (x + 1) >= 1/2:
  // along y = (x - 1) / 2 it is 2 x / (x + 4), which falls to x = 1, y = 0: 2/5; left of that
  // (x + 1) / (x + 4) falls to x = 0: 1/4.
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 3, .start = 2},
                       {.name = "y", .lower = 0, .upper = 3, .start = 2}};
  problem.objectives = {least(function<Interval>(
      {0, 1}, [](const auto& u) { return (u[0] + 2.0 * u[1] + 1.0) / (u[0] + 4.0); },
      Shape::Quasilinear))};
  problem.constraints = {
      {.response = {"slope", "1",
                    function<Interval>(
                        {0, 1}, [](const auto& u) { return (u[1] + 1.0) / (u[0] + 1.0); },
                        Shape::Quasilinear)},
       .lower = 0.5}};
  const Assessment a = optimise(problem).found.assessment;
  CHECK(a.objective.value == Approx(0.25).epsilon(1e-9));
  CHECK(a.global);
  REQUIRE(a.best_possible);
  CHECK(*a.best_possible <= 0.25);
  CHECK(*a.best_possible == Approx(0.25).epsilon(1e-6));
}

TEST_CASE("without bounds of the variables the bound says how far it reaches", "[bound]") {
  Problem problem;
  problem.variables = {{.name = "x", .start = 4}};
  problem.objectives = {least(function<Interval>(
      {0}, [](const auto& u) { return square(u[0] - 3.0); }, Shape::Convex))};
  problem.objectives[0].response.measure = function<Interval>(
      {0}, [](const auto& u) { return square(u[0] - 3.0) + 1.0; }, Shape::Convex);
  const Assessment a = optimise(problem).found.assessment;
  CHECK(a.verdict == Verdict::Certified);
  REQUIRE(a.global);
  CHECK(a.global->find("times the variables' own magnitudes") != std::string::npos);
}

TEST_CASE("a verdict is the same in every box that holds the design", "[bound]") {
  // exp(x) <= 5 as a limit at zero, and its neighbour in a wide box.
  for (const double reach : {3.0, 30.0, 300.0}) {
    Problem problem;
    problem.variables = {{.name = "x", .lower = -reach, .upper = reach, .start = 0}};
    problem.objectives = {most(function<Interval>(
        {0}, [](const auto& u) { return u[0] * 1.0; }, Shape::Linear))};
    problem.constraints = {
        {.response = {"grows", "N",
                      function<Interval>(
                          {0}, [](const auto& u) { return exp(u[0]) - 5.0; }, Shape::Convex)},
         .upper = 0}};
    INFO("reach " << reach);
    const Assessment near = judge(problem, {std::log(5.0)});
    CHECK(near.verdict == Verdict::Certified);
    CHECK(near.limits[0].tolerance == Approx(1e-6 * 5 * std::log(5.0)));
    CHECK(judge(problem, {std::log(5.0) + 1e-4}).verdict == Verdict::Failed);
    const Assessment found = optimise(problem).found.assessment;
    CHECK(found.verdict == Verdict::Certified);
    CHECK(found.objective.value == Approx(std::log(5.0)).epsilon(1e-6));
  }
}

TEST_CASE("a peak is proved however narrow it is", "[bound]") {
  // A bump of height 5 and width 1e-5 on a wave, between any two of the samples.
  const auto bump = [](const auto& u, const auto& angle) {
    const auto far = (angle - u[0]) / 1e-5;
    return sin(angle) + 5.0 / (1.0 + far * far);
  };
  const AutomaticCurve<decltype(bump), Interval> curve({0}, 0, 6, bump, Shape::General);
  for (const double at : {0.123456, 2.7182818, 5.4321}) {
    const double x[] = {at};
    const auto trace = curve.trace(x);
    const ProvedExtreme found = proved_highest(*trace, 1);
    CHECK(found.proved);
    CHECK(found.peak.place.angle == Approx(at).margin(1e-6));
    CHECK(found.peak.value == Approx(5 + std::sin(at)).epsilon(1e-6));
    CHECK(highest(*trace, 1).value < 2);  // what samples see
  }
}

}  // namespace camlaw::optim::dual_bound_test
