// SPDX-License-Identifier: MIT
#include "optim/search/look_around.h"

#include <algorithm>
#include <cmath>

#include "optim/problem/interrupted.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

bool is_quick(const Response& response) {
  return !response.is_curve() && !response.function().is_searched();
}

bool can_look_around(const Problem& problem) {
  constexpr std::size_t kFew = 10;
  return problem.variables.size() <= kFew && is_quick(problem.objective().response) &&
         std::all_of(problem.constraints.begin(), problem.constraints.end(),
                     [](const Constraint& c) { return is_quick(c.response); });
}

/// Whether a design keeps every limit without its tolerance.
bool keeps_limits(const Problem& problem, Design x) {
  return std::all_of(problem.constraints.begin(), problem.constraints.end(),
                     [&](const Constraint& c) {
                       const double value = c.response.function().value(x);
                       return !std::isnan(value) && (!c.lower || value >= *c.lower) &&
                              (!c.upper || value <= *c.upper);
                     });
}

}  // namespace

std::optional<std::vector<double>> better_elsewhere(const Setting& setting,
                                                    const Trail& trail) try {
  constexpr int kDesigns = 501;
  const Problem& problem = setting.problem;
  if (!can_look_around(problem)) return {};
  const double sign = problem.objective().sense == Sense::Minimize ? 1 : -1;
  double least = kInfinity;
  if (trail.is_within_limits()) {
    least = sign * trail.found.assessment.objective.value - trail.sizes.objective_tolerance;
  }
  std::optional<std::vector<double>> best;
  for (std::vector<double>& x : starts(problem, kDesigns, setting.options.seed)) {
    const double value = sign * objective_value(problem.objective(), x);
    if (!(value < least) || !keeps_limits(problem, x)) continue;
    least = value;
    best = std::move(x);
  }
  return best;
} catch (const Interrupted&) {
  throw;
} catch (...) {  // the model throws elsewhere: that takes nothing back
  return {};
}

}  // namespace camlaw::optim
