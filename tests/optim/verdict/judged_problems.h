// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic_curve.h"
#include "optim/verdict/verdict.h"
#include "tests/optim/small_problems.h"

/// Small problems with known answers, for the verdict.
namespace camlaw::optim::verdict_tests {

using namespace small_problems;

inline constexpr double kPi = std::numbers::pi;

/// Judged with the sizes at the problem's own start.
inline Assessment judge(const Problem& problem, const Point& x, bool prove = true) {
  return assess(problem, scales(problem, problem.start()), x, prove);
}

/// Least (x - 2)^2 + (y - 1)^2 in [0, 10]^2 where x + y <= 2, "sum". The nearest point of the line
/// to (2, 1) is (1.5, 0.5); there the gradient (-1, -1) is -1 times the limit's.
inline Problem projection() {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 10, .start = 1},
                       {.name = "y", .lower = 0, .upper = 10, .start = 1}};
  problem.objectives = {least(function<Interval>(
      {0, 1}, [](const auto& u) { return square(u[0] - 2.0) + square(u[1] - 1.0); },
      Shape::Convex))};
  problem.constraints = {
      {.response = {"sum", "mm",
                    function<Interval>(
                        {0, 1}, [](const auto& u) { return u[0] + u[1]; }, Shape::Linear)},
       .upper = 2}};
  return problem;
}

/// Most x + 3 y in [-5, 5]^2 where "wave", x sin(a) + y over a whole turn, keeps its bounds.
inline Problem over_cycle(std::optional<double> lower, std::optional<double> upper, bool enclosed) {
  const auto f = [](const auto& u, const auto& angle) {
    using std::sin;
    return u[0] * sin(angle) + u[1];
  };
  Problem problem;
  problem.variables = {{.name = "x", .lower = -5, .upper = 5, .start = 1},
                       {.name = "y", .lower = -5, .upper = 5, .start = 0}};
  problem.objectives = {most(function(
      {0, 1}, [](const auto& u) { return u[0] + 3.0 * u[1]; }, Shape::Linear))};
  problem.constraints = {
      {.response = {"wave", "mm",
                    enclosed ? curve<Interval>({0, 1}, 0, 2 * kPi, f, Shape::Linear)
                             : curve({0, 1}, 0, 2 * kPi, f, Shape::Linear)},
       .lower = lower,
       .upper = upper}};
  return problem;
}

}  // namespace camlaw::optim::verdict_tests
