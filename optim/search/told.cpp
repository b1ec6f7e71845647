// SPDX-License-Identifier: MIT
#include "optim/search/told.h"

#include "optim/search/interruptible.h"
#include "optim/search/plan.h"

namespace camlaw::optim {

std::vector<Push> told_at(const Problem& problem, const Scales& scales, Design x, Aim aim) {
  const bool optimum = aim == Aim::Optimum;
  for (const Solver* solver :
       optimum ? plan(problem, "auto").solvers : least_violation_plan(problem)) {
    if (!solver->is_sharp()) continue;
    Attempt attempt = exchange(problem, scales, x, *solver, {}, aim);
    if (is_interruption(attempt.error)) std::rethrow_exception(attempt.error);
    if (!attempt.told.empty()) return std::move(attempt.told);
  }
  return {};
}

namespace {

/// None where the limit does not vanish at that rest.
std::optional<Function> function_of(const Problem& problem, const Push& push) {
  const Response& response = push.constraint ? problem.constraints[*push.constraint].response
                                             : problem.objective().response;
  if (push.place) return response.curve().at(*push.place);
  if (!push.rest) return response.function();
  const Constraint& c = problem.constraints[*push.constraint];
  // Of a curve whose places stand still the rests are those of any design.
  const double bound = push.sign > 0 ? c.upper.value_or(0) : c.lower.value_or(0);
  const auto rests = response.curve().rests(bound, problem.start());
  if (*push.rest >= rests.size()) return {};
  return rests[*push.rest].leading;
}

}  // namespace

void find_functions(const Problem& problem, std::vector<Push>& pushes) {
  for (Push& push : pushes) {
    if (!push.variable && !push.function) push.function = function_of(problem, push);
  }
  std::erase_if(pushes, [](const Push& push) { return !push.variable && !push.function; });
}

Teller teller_at(const Problem& problem, const Scales& scales, Design x, Aim aim) {
  return [&problem, &scales, x, aim] { return told_at(problem, scales, x, aim); };
}

}  // namespace camlaw::optim
