// SPDX-License-Identifier: MIT
#include "optim/search/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "optim/solvers/interior.h"
#include "optim/solvers/sequential.h"

namespace camlaw::optim {
namespace {

/// Whether all limits are known to be linear.
bool has_linear_limits(const Problem& problem) {
  return std::all_of(problem.constraints.begin(), problem.constraints.end(),
                     [](const Constraint& c) { return c.response.shape() == Shape::Linear; });
}

/// Whether an objective or a limit is about a curve, so that its rows are added one by one.
bool has_curves(const Problem& problem) {
  return problem.objective().response.is_curve() ||
         std::any_of(problem.constraints.begin(), problem.constraints.end(),
                     [](const Constraint& c) { return c.response.is_curve(); });
}

std::string variables_text(std::size_t n) {
  return fmt::format("{} variable{}", n, n == 1 ? "" : "s");
}

}  // namespace

bool is_large(const Problem& problem) {
  // Random starts lead nowhere where so many coefficients spread so far: a free rise of 24
  // coefficients took 6.3 s with eight starts, 0.6 s with those of large problems.
  constexpr std::size_t kMany = 30, kSeveral = 6;
  constexpr double kFar = 30;  // typical changes between the bounds
  if (problem.variables.size() > kMany) return true;
  const std::vector<double> scales = variable_scales(problem);
  std::size_t far = 0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double range = problem.variables[i].upper - problem.variables[i].lower;
    if (std::isfinite(range) && range > kFar * scales[i]) ++far;
  }
  return far >= kSeveral;
}

bool is_linear(const Problem& problem) {
  return problem.objective().response.shape() == Shape::Linear && has_linear_limits(problem);
}

Plan plan(const Problem& problem, const std::string& wanted) {
  // The matrices of slsqp are dense, and its time grows with the cube of their size.
  constexpr std::size_t kSmall = 30;
  const Solver& ipopt = ipopt_solver();
  const Solver& slsqp = find_solver("slsqp");
  const std::size_t n = problem.variables.size(), m = problem.constraints.size();
  if (wanted != "auto") {
    const Solver& chosen = find_solver(wanted);
    // A global method finds the valley; a local one finds its bottom.
    if (chosen.is_global()) return {{&chosen, &slsqp, &ipopt}, "as asked for"};
    return {{&chosen}, "as asked for"};
  }
  const bool small = n <= kSmall && m <= kSmall;
  if (is_linear(problem)) {
    // A vertex is exact, where no rows are added to it.
    const bool is_whole = n <= kSmall && !has_curves(problem);
    std::vector<const Solver*> solvers = {&interior_solver(), &clp_solver(), &ipopt};
    if (is_whole) std::swap(solvers[0], solvers[1]);
    if (small) solvers.push_back(&slsqp);  // its matrices are dense
    return {solvers, fmt::format("{}: linear, of {}; {}{} where that is not enough",
                                 solvers[0]->name(), variables_text(n), solvers[1]->name(),
                                 small ? ", ipopt and slsqp" : " and ipopt")};
  }
  if (is_large(problem)) {
    return {{&sequential_solver(), &ipopt},
            fmt::format("sequential: {} and {} limits, sparse; ipopt where that is not enough",
                        variables_text(n), m)};
  }
  if (small) {
    return {{&slsqp, &ipopt},
            fmt::format("slsqp: {}, exact gradients; ipopt where that is not enough",
                        variables_text(n))};
  }
  return {{&ipopt}, fmt::format("ipopt: {} and {} limits, sparse", variables_text(n), m)};
}

std::vector<const Solver*> least_violation_plan(const Problem& problem) {
  // The matrices of slsqp are dense, and its time grows with the cube of their size.
  constexpr std::size_t kSmall = 30;
  const Solver& ipopt = ipopt_solver();
  const bool small = problem.variables.size() + problem.constraints.size() <= kSmall;
  std::vector<const Solver*> solvers;
  if (has_linear_limits(problem)) solvers = {&interior_solver(), &clp_solver()};
  if (small) solvers.push_back(&find_solver("slsqp"));
  solvers.push_back(&ipopt);
  return solvers;
}

}  // namespace camlaw::optim
