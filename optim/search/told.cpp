// SPDX-License-Identifier: MIT
#include "optim/search/told.h"

#include "optim/search/plan.h"

namespace camlaw::optim {

std::vector<Push> told_at(const Problem& problem, const Sizes& sizes, Design x, Aim aim) {
  const bool optimum = aim == Aim::Optimum;
  for (const Solver* solver :
       optimum ? plan(problem, "auto").solvers : least_violation_plan(problem)) {
    if (solver->linear_end() == LinearEnd::Near || refusal(problem, sizes, x, *solver)) break;
    Attempt attempt = exchange(problem, sizes, x, *solver, {}, aim);
    if (attempt.error) std::rethrow_exception(attempt.error);
    if (!attempt.told.empty()) return std::move(attempt.told);
  }
  return {};
}

}  // namespace camlaw::optim
