// SPDX-License-Identifier: MIT
#include "optim/search/along_edge.h"

#include <algorithm>
#include <utility>

#include "optim/search/local.h"
#include "optim/search/with_numbers.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Makes limits of functions that are above 0 at a design; none where one is not.
std::vector<Constraint> kept_above(const std::vector<Function>& functions, Design at) {
  std::vector<Constraint> limits;
  for (const Function& f : functions) {
    const double there = f.value(at);
    if (!(there > 0)) return {};
    limits.push_back({{"margin", "1", f}, there, {}, {}, there});
  }
  return limits;
}

}  // namespace

void search_along_edge(const Setting& setting, Trail& trail) {
  constexpr double kShares[] = {1e-2, 1e-4, 1e-6};
  constexpr double kTolerance = 0.1;  // of the share
  const Problem& problem = setting.problem;
  Found& found = trail.found;
  if (!setting.original.domain || is_settled(found.assessment)) return;
  std::vector<double> x = problem.start();
  const std::vector<Constraint> margins = kept_above(setting.original.domain(), x);
  Problem within = setting.original;
  within.domain = {};
  OptimiseOptions own = setting.options;
  own.starts = 1;
  for (const double share : kShares) {
    if (margins.empty() || setting.deadline.passed()) return;
    within.constraints = setting.original.constraints;
    for (Constraint margin : margins) {
      *margin.lower *= share;
      margin.tolerance = kTolerance * *margin.lower;
      within.constraints.push_back(std::move(margin));
    }
    for (std::size_t i = 0; i < x.size(); ++i) within.variables[i].start = x[i];
    Found next = search_continuous(within, own, setting.deadline, false);
    found.add_work(next);
    if (!has_numbers(next) || !is_feasible(next.assessment)) continue;
    x = std::move(next.x);
    Sizes there = sizes(problem, x);
    Assessment judged = assess(problem, there, x, false);
    if (!better(problem, judged, found.assessment)) continue;
    found.x = x;
    found.assessment = std::move(judged);
    trail.sizes = std::move(there);
    trail.told.clear();
    trail.settled_at_edge = is_settled(next.assessment) ? x : std::vector<double>();
  }
}

}  // namespace camlaw::optim
