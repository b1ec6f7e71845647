// SPDX-License-Identifier: MIT
#include "optim/verdict/limits_in_haste.h"

#include <cmath>

namespace camlaw::optim {

void look_in_haste(const Problem& problem, Design x, std::vector<LimitReport>& limits) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    LimitReport& limit = limits[i];
    const bool is_curve = c.response.is_curve();
    if (limit.proved || (!is_curve && !c.response.function().is_searched())) continue;
    if (!std::isnan(limit.margin)) show_side(c, x, limit.is_upper, limit);
    limit.met = limit.margin >= -limit.tolerance;
    limit.left = Bounds{};
    if (!is_curve) continue;
    const std::vector<double> breaks = c.response.curve().trace(x)->breaks();
    limit.left = Bounds{breaks.front(), breaks.back()};
  }
}

void judge_in_haste(const Problem& problem, Design x, Assessment& assessment) {
  if (assessment.verdict != Verdict::Feasible) return;
  look_in_haste(problem, x, assessment.limits);
  if (!is_feasible(assessment)) assessment = assess_in_haste(problem, x);
}

}  // namespace camlaw::optim
