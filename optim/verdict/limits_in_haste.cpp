// SPDX-License-Identifier: MIT
#include "optim/verdict/limits_in_haste.h"

#include <cmath>

namespace camlaw::optim {
namespace {

/// A limit with its shown side looked at closely, or the other one where that leaves less room. A
/// side with a price stays unless the other one is broken: the price is of it.
LimitReport looked_at(const Constraint& c, Design x, const LimitReport& limit) {
  LimitReport shown = limit;
  show_side(c, x, limit.is_upper, shown);
  if (!c.lower || !c.upper || std::isnan(shown.margin)) return shown;
  LimitReport other = limit;
  show_side(c, x, !limit.is_upper, other);
  const bool is_nearer = !(other.margin >= shown.margin);  // or not a number
  const bool is_broken = !(other.margin >= -limit.tolerance);
  return is_nearer && (is_broken || limit.multiplier == 0) ? other : shown;
}

}  // namespace

void look_in_haste(const Problem& problem, Design x, std::vector<LimitReport>& limits) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    LimitReport& limit = limits[i];
    const bool is_curve = c.response.is_curve();
    if (limit.proved || (!is_curve && !c.response.function().is_searched())) continue;
    if (!std::isnan(limit.margin)) limit = looked_at(c, x, limit);
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
