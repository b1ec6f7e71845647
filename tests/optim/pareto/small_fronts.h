// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/pareto.h"
#include "tests/optim/search/search_problems.h"

/// Small problems with several objectives and known fronts.
namespace camlaw::optim::front_tests {

using namespace search_tests;

inline Objective cost(const std::string& name, Function f) {
  return {{name, "N", std::move(f)}, Sense::Minimize, {}, {}};
}

/// (x - a)^2 + (y - b)^2.
inline Function distance(double a, double b) {
  return convex({0, 1}, [a, b](const auto& u) { return square(u[0] - a) + square(u[1] - b); });
}

/// Squares of the distances from (0, 0) and (1, 0): f2 = (1 - sqrt f1)^2, x = sqrt f1, y = 0.
inline Problem two_centres() {
  return {"two centres",
          {variable("x", -2, 2, 0.3), variable("y", -2, 2, 0.4)},
          {cost("f1", distance(0, 0)), cost("f2", distance(1, 0))},
          {}};
}

/// With a limit that cuts the front: x at most 0.6, so that f1 is at most 0.36.
inline Problem two_centres_limited() {
  Problem problem = two_centres();
  problem.constraints = {
      at_most("width", linear({0}, [](const auto& u) { return 1.0 * u[0]; }), 0.6)};
  return problem;
}

/// Squares of the distances from three corners; every design in the triangle is on the front.
inline Problem three_centres() {
  Problem problem = two_centres();
  problem.name = "three centres";
  problem.objectives.push_back(cost("f3", distance(0, 1)));
  return problem;
}

/// Two centres in each of two rooms, which a choice picks; the second room is better near (1, 0).
inline ProblemSpace two_rooms() {
  ProblemSpace space;
  space.choices = {{"room", "", {"first", "second"}, {}, 0}};
  space.problem = [](const std::vector<std::size_t>& options) {
    Problem problem = two_centres();
    const double far = options.at(0) == 0 ? 0.0 : 0.2;
    problem.objectives[0] = cost(
        "f1", convex({0, 1}, [far](const auto& u) { return square(u[0]) + square(u[1]) + far; }));
    problem.objectives[1] = cost("f2", convex({0, 1}, [far](const auto& u) {
                                   return square(u[0] - 1.0) + square(u[1]) - 0.5 * far;
                                 }));
    return problem;
  };
  return space;
}

inline std::vector<Costs> costs_of(const Front& front) { return optim::costs_of(front.points); }

}  // namespace camlaw::optim::front_tests
