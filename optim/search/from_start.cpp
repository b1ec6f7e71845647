// SPDX-License-Identifier: MIT
#include "optim/search/from_start.h"

#include <utility>

#include "optim/search/feasible.h"
#include "optim/search/rescaling.h"

namespace camlaw::optim {
namespace {

/// Searches from where a search has ended, in the scales of that place, where they are others. A
/// linear problem is solved once more in any case, with the peaks of that place as its first rows:
/// that sharpens the multipliers, and takes less than another method.
void search_rescaled(std::vector<double> x, const Solver& solver, const Setting& setting,
                     Trail& trail, Reached& reached) {
  constexpr int kTimes = 3;  // scales that still differ tenfold after that do not settle
  for (int i = 0; i < kTimes; ++i) {
    Scales there = scales(setting.problem, x);
    const bool sharpens = i == 0 && solver.solves_linear_programs();
    if (!differ(there, trail.scales) && !sharpens) return;
    trail.scales = std::move(there);
    const Attempt tried = attempt(x, solver, setting, trail, reached);
    const bool ended = tried.error || tried.x.empty() || setting.deadline.passed();
    if (ended || is_settled(reached.latest)) return;
    x = tried.x;
  }
}

/// Where the set of designs is convex, the design of least violation tells at once whether there
/// are any: then no other method, and no other start, needs to try.
void look_for_emptiness(const Setting& setting, Trail& trail, Reached& reached) {
  const bool unknown = !trail.found.x.empty() && !trail.knows_design();
  if (convex_set(setting.original) && unknown && !setting.deadline.passed())
    find_feasible(setting, trail, reached);
}

}  // namespace

Assessment search_from_start(Design start, const Setting& setting, Trail& trail) {
  Reached reached;
  std::vector<double> x(start.begin(), start.end());
  if (trail.found.solves > 0)
    trail.scales = scales(setting.problem, x);  // of the first they are known
  for (const Solver* solver : setting.plan.solvers) {
    const Attempt tried = attempt(x, *solver, setting, trail, reached);
    if (tried.error || setting.deadline.passed()) break;
    if (solver->is_global() && !tried.x.empty()) {
      x = tried.x;  // polished by the next
      continue;
    }
    // Where all iterations led to no design within the limits, other scales lead to none either.
    const bool in_vain = tried.status == Status::IterationLimit && !trail.knows_design();
    trail.in_vain = trail.in_vain || in_vain;
    const bool goes_on = !tried.x.empty() && tried.status != Status::Unbounded && !in_vain;
    if (!is_settled(reached.latest) && goes_on)
      search_rescaled(tried.x, *solver, setting, trail, reached);
    if (is_settled(reached.latest) || !trail.thrown.empty() || setting.deadline.passed()) break;
    look_for_emptiness(setting, trail, reached);
    if (is_settled(reached.latest) || trail.is_infeasible()) break;
    // Where the first start has led to no design by any method, the least violation, which is
    // sought next and from many places, tells more than other methods do from each start.
    if (trail.none_elsewhere && !trail.is_within_limits()) break;
    // Of many variables other methods take far longer: not where a design is known from elsewhere.
    const bool gives_up = solver->is_sharp() && !solver->solves_linear_programs();
    if (gives_up && trail.design_elsewhere && !trail.is_within_limits()) break;
  }
  return reached.best;
}

}  // namespace camlaw::optim
