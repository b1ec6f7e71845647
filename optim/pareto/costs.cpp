// SPDX-License-Identifier: MIT
#include "optim/pareto/costs.h"

#include "optim/cycle/scales.h"

namespace camlaw::optim {

std::vector<double> costs(const Problem& problem, Design x) {
  std::vector<double> result;
  for (const Objective& objective : problem.objectives) {
    result.push_back(as_cost(objective, objective_value(objective, x)));
  }
  return result;
}

double as_cost(const Objective& objective, double value) {
  return objective.sense == Sense::Minimize ? value : -value;
}

Constraint at_most(const Objective& objective, double cost) {
  Constraint limit;
  limit.response = objective.response;
  const double bound = as_cost(objective, cost);
  const bool from_below = objective.sense == Sense::Maximize;
  (from_below ? limit.lower : limit.upper) = bound;
  if (objective.part == Part::Magnitude) limit.lower = -bound;
  return limit;
}

}  // namespace camlaw::optim
