// SPDX-License-Identifier: MIT
#include "optim/pareto/costs.h"

#include "optim/cycle/sizes.h"

namespace camlaw::optim {

std::vector<double> costs(const MultiProblem& problem, Design x) {
  std::vector<double> result;
  for (const Objective& objective : problem.objectives) {
    result.push_back(as_cost(objective, objective_value(objective, x)));
  }
  return result;
}

}  // namespace camlaw::optim
