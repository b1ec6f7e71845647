// SPDX-License-Identifier: MIT
#include "optim/search/told.h"

#include "optim/search/interruptible.h"
#include "optim/search/plan.h"

namespace camlaw::optim {

std::vector<Push> told_at(const Problem& problem, const Sizes& sizes, Design x, Aim aim) {
  const bool optimum = aim == Aim::Optimum;
  for (const Solver* solver :
       optimum ? plan(problem, "auto").solvers : least_violation_plan(problem)) {
    if (!solver->is_sharp()) continue;
    Attempt attempt = exchange(problem, sizes, x, *solver, {}, aim);
    if (is_interruption(attempt.error)) std::rethrow_exception(attempt.error);
    if (!attempt.told.empty()) return std::move(attempt.told);
  }
  return {};
}

Teller teller_at(const Problem& problem, const Sizes& sizes, Design x, Aim aim) {
  return [&problem, &sizes, x, aim] { return told_at(problem, sizes, x, aim); };
}

}  // namespace camlaw::optim
