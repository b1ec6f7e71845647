// SPDX-License-Identifier: MIT
#include "optim/search/look_around.h"

#include <algorithm>
#include <cmath>

#include "optim/problem/interrupted.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

/// Whether a response is a number that is no search itself.
bool is_quick(const Response& response) {
  return !response.is_curve() && !response.function().is_searched();
}

/// How many designs, the start among them, are looked at: few where each takes a search over the
/// cycle, none where they would not fill the box.
int designs_to_look_at(const Problem& problem) {
  // Variables: in more dimensions so many points leave the box empty.
  constexpr std::size_t kFew = 10, kFewOfSearches = 4;
  // The start and others: among 384 others one led to 8.73 N m of two cams, where eight starts had
  // all ended at 11.94.
  constexpr int kQuick = 501, kSearched = 385;
  if (problem.variables.size() > (is_quick(problem) ? kFew : kFewOfSearches)) return 0;
  return is_quick(problem) ? kQuick : kSearched;
}

/// Whether a design keeps every limit without its tolerance.
bool keeps_limits(const Setting& setting, const Trail& trail, Design x) {
  return !(largest_violation(setting.problem, trail.scales, x) > 0);
}

}  // namespace

bool is_quick(const Problem& problem) {
  return is_quick(problem.objective().response) &&
         std::all_of(problem.constraints.begin(), problem.constraints.end(),
                     [](const Constraint& c) { return is_quick(c.response); });
}

std::optional<std::vector<double>> better_elsewhere(const Setting& setting,
                                                    const Trail& trail) try {
  const Problem& problem = setting.problem;
  const int designs = designs_to_look_at(problem);
  if (designs == 0) return {};
  const double sign = problem.objective().sense == Sense::Minimize ? 1 : -1;
  double least = kInfinity;
  if (trail.is_within_limits()) {
    least = sign * trail.found.assessment.objective.value - trail.scales.objective_tolerance;
  }
  std::optional<std::vector<double>> best;
  for (std::vector<double>& x : starts(problem, designs, setting.options.seed)) {
    const double value = sign * objective_value(problem.objective(), x);
    if (!(value < least) || !keeps_limits(setting, trail, x)) continue;
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
