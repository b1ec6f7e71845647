// SPDX-License-Identifier: MIT
#include "optim/search/with_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "optim/problem/starts.h"
#include "optim/search/from_start.h"
#include "optim/search/local.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

bool are_numbers(const Assessment& a) {
  return std::isfinite(a.objective.value) && !std::isinf(worst_violation(a.limits));
}

/// Makes the problem of finding any design that meets those limits that are numbers at a design,
/// with room to each bound of a share of it; none where there is no such limit. At the edge of what
/// limits of validity allow a model may be infinite.
std::optional<Problem> with_numbers_only(const Problem& problem, Design x, double share) {
  Problem result = problem;
  result.objectives = {no_objective()};
  result.constraints.clear();
  for (Constraint c : problem.constraints) {
    const double value = objective_value(
        {c.response, Sense::Minimize, c.response.is_curve() ? Part::Magnitude : Part::Value}, x);
    if (!std::isfinite(value)) continue;
    const double room =
        share * std::max(std::abs(c.lower.value_or(0)), std::abs(c.upper.value_or(0)));
    const bool has_room = !(c.lower && c.upper) || *c.upper - *c.lower > 2 * room;
    if (has_room && c.upper) *c.upper -= room;
    if (has_room && c.lower) *c.lower += room;
    result.constraints.push_back(std::move(c));
  }
  if (result.constraints.empty()) return {};
  return result;
}

/// Searches from a design within the limits that are numbers everywhere.
void search_from_valid(const Setting& setting, Trail& trail) {
  constexpr double kRoom = 1e-3;
  const Problem& problem = setting.problem;
  OptimiseOptions own = setting.options;
  own.solver = "auto";
  const std::vector<double> start = problem.start();
  Found valid;
  for (const double share : {kRoom, 0.0}) {  // only without room an empty set says something
    const auto seeking = with_numbers_only(problem, start, share);
    if (!seeking || setting.deadline.passed()) return;
    valid = search_continuous(*seeking, own, setting.deadline, false);
    if (!is_feasible(valid.assessment)) continue;
    search_from_start(valid.x, setting, trail);
    return;
  }
  if (valid.assessment.verdict != Verdict::Infeasible) return;
  const Sizes there = sizes(problem, valid.x);
  Assessment& best = trail.found.assessment;
  trail.found.x = valid.x;
  best = valid.assessment;
  best.objective = objective_report(problem, there, valid.x, false);
  best.limits = limit_reports(problem, there, valid.x, false);
  best.reason = fmt::format("{}; {}", valid.assessment.reason,
                            undefined_at(setting.original, valid.x, "the nearest design"));
}

/// Searches from the first places of the box at which the model gives numbers, evenly spread or by
/// orders of magnitude.
void search_all_over(const Setting& setting, Trail& trail) {
  constexpr int kPlaces = 128, kEnough = 3;
  const Problem& problem = setting.problem;
  const auto even = starts(problem, kPlaces, setting.options.seed);
  const auto by_magnitude = starts_by_magnitude(problem, kPlaces, setting.options.seed);
  int searched = 0;
  for (std::size_t i = 1; i < even.size(); ++i) {
    for (const auto* places : {&by_magnitude, &even}) {
      if (searched == kEnough || setting.deadline.passed()) return;
      const std::vector<double>& x = (*places)[i];
      if (!are_numbers(assess_in_haste(problem, x))) continue;
      ++searched;
      search_from_start(x, setting, trail);
    }
  }
}

/// Where a search ran from a start with numbers to a design without them: searches from designs
/// between the two, each half as far from the edge of what has numbers as the one before. If all of
/// them run over the edge, the last of them that meets the limits is the answer.
void retreat(const Setting& setting, Trail& trail) {
  constexpr int kHalvings = 20, kSearches = 8;
  const Problem& problem = setting.problem;
  std::vector<double> good = problem.start();
  std::vector<double> bad = trail.found.x;
  if (bad.empty() || !are_numbers(assess_in_haste(problem, good))) return;
  std::vector<double> last;
  const auto keep_if_within = [&](const std::vector<double>& x) {
    if (is_feasible(assess_in_haste(problem, x))) last = x;
  };
  keep_if_within(good);
  int searches = 0;
  for (int i = 0; i < kHalvings && !setting.deadline.passed(); ++i) {
    std::vector<double> middle(good.size());
    for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = std::midpoint(good[k], bad[k]);
    if (!are_numbers(assess_in_haste(problem, middle))) {
      bad = middle;
      continue;
    }
    good = middle;
    keep_if_within(good);
    if (++searches > kSearches) continue;
    search_from_start(good, setting, trail);
    if (has_numbers(trail.found)) return;
  }
  if (last.empty()) return;
  trail.sizes = sizes(problem, last);
  trail.found.x = last;
  trail.found.assessment = assess(problem, trail.sizes, last, setting.prove);
}

}  // namespace

bool has_numbers(const Found& found) { return !found.x.empty() && are_numbers(found.assessment); }

void seek_numbers(const Setting& setting, Trail& trail) {
  retreat(setting, trail);
  if (has_numbers(trail.found)) return;
  search_from_valid(setting, trail);
  if (!has_numbers(trail.found) && !trail.is_infeasible()) search_all_over(setting, trail);
}

}  // namespace camlaw::optim
