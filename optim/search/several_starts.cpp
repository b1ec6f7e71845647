// SPDX-License-Identifier: MIT
#include "optim/search/several_starts.h"

#include <cmath>
#include <utility>

#include "optim/problem/starts.h"
#include "optim/search/convex_part.h"
#include "optim/search/from_start.h"
#include "optim/search/interruptible.h"
#include "optim/search/told.h"
#include "optim/verdict/conditions.h"
#include "optim/verdict/subdivision.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Whether no others are needed after the first start: it has come near what theory says that no
/// design passes, or the box of few variables, divided into a few parts, holds nothing better than
/// where it ended.
bool leaves_nothing(const Setting& setting, const Trail& trail) {
  constexpr int kFewBoxes = 300;  // less work than the seven other starts that it may spare
  const OptimiseOptions& how = setting.options;
  const bool has_others = !how.starts && count_of_starts(setting) > 1;
  if (!has_others || !is_settled(trail.found.assessment)) return false;
  if (is_near_limit(setting.original, trail.found.assessment)) return true;
  if (!how.divides) return false;
  const Problem guarded = interruptible(setting.original, setting.deadline);
  const std::vector<double>& x = trail.found.x;
  const Scales there = scales(guarded, x);
  const auto division = subdivided(
      guarded, there, x, [&] { return setting.deadline.passed(); }, kFewBoxes);
  if (!division || division->better) return false;
  const double gain = std::abs(trail.found.assessment.objective.value - division->best_possible);
  return gain <= kBoundTolerance * there.objective * objective_measure(guarded, there, x);
}

/// Of what has been told the functions; after a stop it is not needed, and left out.
void find_told(const Setting& setting, Trail& trail) {
  try {
    find_functions(setting.problem, trail.told);
  } catch (const Interrupted&) {
    trail.told.clear();
  }
}

}  // namespace

int count_of_starts(const Setting& setting) {
  // Seven drawn at random miss a basin of a third of the box once in 17 times.
  constexpr int kStarts = 8;
  // These begin nearer to a design, and each takes longer.
  constexpr int kStartsOfMany = 3;
  if (setting.options.starts) return *setting.options.starts;
  const bool one_is_enough = why_convex(setting.original) && !needs_slope(setting.problem);
  if (one_is_enough || setting.plan.solvers.front()->is_global()) return 1;
  return is_large(setting.problem) ? kStartsOfMany : kStarts;
}

FromStart search_one(const Setting& setting, int number, FirstStart first, const Scales* stated) {
  FromStart result;
  Trail& trail = result.trail;
  trail.in_vain = number > 0 && first == FirstStart::InVain;
  trail.design_elsewhere = number > 0 && first == FirstStart::Led;
  trail.none_elsewhere = number > 0 && first != FirstStart::Led;
  trail.found.solver = setting.plan.solvers.front()->name();
  trail.found.why_solver = setting.plan.why;
  trail.found.starts = number + 1;
  trail.found.planned_starts = count_of_starts(setting);
  try {
    const bool as_it_is =
        number == 0 || !is_large(setting.problem) || setting.plan.solvers.front()->is_global();
    const std::vector<double> drawn = nth_start(setting.problem, number, setting.options.seed);
    const std::vector<double> start =
        as_it_is ? drawn : begun_in_convex_part(drawn, setting, trail);
    const bool is_stated = stated != nullptr && start == setting.problem.start();
    trail.scales = is_stated ? *stated : scales(setting.problem, start);
    const Assessment end = search_from_start(start, setting, trail);
    if (is_feasible(end)) result.objective = end.objective.value;
    if (number == 0 && leaves_nothing(setting, trail)) result.end = StartEnd::BestOfAll;
  } catch (const Interrupted&) {
    result.end = StartEnd::CutShort;
  } catch (...) {
    trail.thrown = words_of(std::current_exception());
    result.end = StartEnd::Thrown;
  }
  return result;
}

bool ends_search(const FromStart& start) {
  const Assessment& a = start.trail.found.assessment;
  const bool best_of_all = is_settled(a) && a.is_global;
  return best_of_all || start.trail.is_infeasible() || start.end != StartEnd::Itself;
}

void search_starts(const Setting& setting, Trail& trail, std::vector<double>& ends,
                   std::vector<FromStart> known) {
  Found& found = trail.found;
  const int count = count_of_starts(setting);
  found.planned_starts = count;
  FirstStart first = FirstStart::Led;
  bool is_cut = false;
  for (int number = 0; number < count; ++number) {
    const auto at = static_cast<std::size_t>(number);
    const bool is_known = at < known.size();
    if (!is_known && number > 0 && (is_cut || setting.deadline.passed())) break;
    const Scales* stated = number == 0 && !trail.scales.variables.empty() ? &trail.scales : nullptr;
    FromStart start = is_known ? std::move(known[at]) : search_one(setting, number, first, stated);
    if (is_known) find_told(setting, start.trail);
    if (number == 0) first = told_of(start);
    const bool is_last = ends_search(start);
    const StartEnd end = start.end;
    ends.push_back(start.objective);
    trail.join(setting.problem, std::move(start.trail));
    if (end == StartEnd::Thrown) throw ModelThrew();
    is_cut = is_cut || end == StartEnd::CutShort;
    if (!is_last || is_cut) continue;
    found.planned_starts = found.starts;
    break;
  }
  if (is_cut) throw Interrupted();
}

}  // namespace camlaw::optim
