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

/// Whether a problem asks for nothing that has no value somewhere but its limits.
bool asks_for_limits_alone(const Problem& problem) {
  const Response& sought = problem.objective().response;
  return !problem.domain && !sought.is_curve() && sought.function().inputs().empty();
}

/// Makes the problem of finding any design that meets those limits that are numbers at a design,
/// with room to each bound of a share of it; none where there is no such limit, or where that asks
/// for no less than the problem does: the search for it would end as this one has, and ask for the
/// same again without end. At the edge of what limits of validity allow a model may be infinite.
std::optional<Problem> with_numbers_only(const Problem& problem, Design x, double share) {
  Problem result = problem;
  result.objectives = {no_objective()};
  result.constraints.clear();
  result.domain = {};
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
  const bool asks_for_less =
      result.constraints.size() < problem.constraints.size() || !asks_for_limits_alone(problem);
  if (result.constraints.empty() || !asks_for_less) return {};
  return result;
}

/// Searches from a design within the limits that are numbers everywhere.
void search_from_valid(const Setting& setting, Trail& trail) {
  // Of the bounds: a search that begins at the edge itself steps over it.
  constexpr double kRoom = 1e-3;
  const Problem& problem = setting.problem;
  OptimiseOptions own = setting.options;
  own.solver = "auto";
  const std::vector<double> start = problem.start();
  Found valid;
  for (const double share : {kRoom, 0.0}) {  // only without room an empty set says something
    const auto seeking = with_numbers_only(problem, start, share);
    if (!seeking || setting.deadline.passed()) return;
    valid = search_continuous(*seeking, own, setting.deadline, Depth::Node);
    if (!is_feasible(valid.assessment)) continue;
    search_from_start(valid.x, setting, trail);
    return;
  }
  if (valid.assessment.verdict != Verdict::Infeasible) return;
  const Scales there = scales(problem, valid.x);
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
  // An empty set is looked for at as many places (least_violating); each of the three is a whole
  // search.
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

/// The designs from a start with numbers to one without them, by shares from 0 to 1.
class WayToEdge {
 public:
  WayToEdge(const Problem& problem, std::vector<double> end)
      : problem_(problem), start_(problem.start()), end_(std::move(end)) {}

  std::vector<double> at(double share) const {
    std::vector<double> x(start_.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::lerp(start_[i], end_[i], share);
    return x;
  }
  Assessment judged(double share) const { return assess_in_haste(problem_, at(share)); }

 private:
  const Problem& problem_;
  std::vector<double> start_, end_;
};

/// Whether all limits are met without using their tolerances.
bool is_strictly_within(const Assessment& a) {
  return is_feasible(a) && std::all_of(a.limits.begin(), a.limits.end(),
                                       [](const LimitReport& limit) { return limit.margin >= 0; });
}

/// The best design within the limits that a retreat has met.
struct Retreated {
  std::vector<double> x;
  Assessment assessment;

  void consider(const Problem& problem, const WayToEdge& way, double share, const Assessment& a) {
    if (!is_strictly_within(a) || (!x.empty() && !better(problem, a, assessment))) return;
    x = way.at(share);
    assessment = a;
  }
};

/// Where a search ran from a start with numbers to a design without them: searches from designs
/// between the two, each half as far from the edge of what has numbers as the one before. If all of
/// them run over the edge, a last one begins at the last design of the way that meets the limits.
/// Returns the best design that it has met on the way.
Retreated retreat(const Setting& setting, Trail& trail) {
  // Each search halves the distance, to 1/256 of it; the edge is known to a millionth of the way,
  // and the last design within the limits to the last bits of a double.
  constexpr int kSearches = 8, kHalvings = 20, kToLimit = 50;
  const Problem& problem = setting.problem;
  Retreated met;
  if (trail.found.x.empty()) return met;
  const WayToEdge way(problem, trail.found.x);
  const Assessment start = way.judged(0);
  if (!are_numbers(start)) return met;
  met.consider(problem, way, 0, start);
  double numbers = 0, edge = 1;  // up to where there are numbers, and where there are none
  double within = is_strictly_within(start) ? 0 : -1, beyond = 1;  // the same of the limits
  int searches = 0;
  for (int i = 0; i < kHalvings && !setting.deadline.passed(); ++i) {
    const double middle = std::midpoint(numbers, edge);
    const Assessment there = way.judged(middle);
    met.consider(problem, way, middle, there);
    (is_strictly_within(there) ? within : beyond) = middle;
    (are_numbers(there) ? numbers : edge) = middle;
    if (numbers != middle) continue;
    if (++searches > kSearches) break;
    search_from_start(way.at(middle), setting, trail);
    if (has_numbers(trail.found)) return met;
  }
  if (within < 0) return met;
  if (beyond < within) beyond = 1;
  for (int i = 0; i < kToLimit && !setting.deadline.passed(); ++i) {
    const double middle = std::midpoint(within, beyond);
    const Assessment there = way.judged(middle);
    met.consider(problem, way, middle, there);
    (is_strictly_within(there) ? within : beyond) = middle;
  }
  search_from_start(way.at(within), setting, trail);
  return met;
}

}  // namespace

bool has_numbers(const Found& found) { return !found.x.empty() && are_numbers(found.assessment); }

void seek_numbers(const Setting& setting, Trail& trail) {
  const Retreated met = retreat(setting, trail);
  if (!has_numbers(trail.found)) search_from_valid(setting, trail);
  if (!has_numbers(trail.found) && !trail.is_infeasible()) search_all_over(setting, trail);
  if (met.x.empty()) return;
  const Problem& problem = setting.problem;
  const Assessment& found = trail.found.assessment;
  if (has_numbers(trail.found) && !better(problem, met.assessment, found)) return;
  const Scales there = scales(problem, met.x);
  trail.take(met.x, there, assess(problem, there, met.x, setting.proves()));
}

}  // namespace camlaw::optim
