// SPDX-License-Identifier: MIT
#include "optim/search/local.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "optim/cycle/proof_time.h"
#include "optim/cycle/remembered.h"
#include "optim/problem/starts.h"
#include "optim/search/along_edge.h"
#include "optim/search/convex_part.h"
#include "optim/search/from_start.h"
#include "optim/search/hopeless.h"
#include "optim/search/interruptible.h"
#include "optim/search/look_around.h"
#include "optim/search/proof.h"
#include "optim/search/told.h"
#include "optim/search/unbounded.h"
#include "optim/search/with_numbers.h"
#include "optim/verdict/conditions.h"
#include "optim/verdict/limits_in_haste.h"
#include "optim/verdict/none_possible.h"
#include "optim/verdict/subdivision.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Where a limit is passed whatever the design, there is no need to search.
void blame(const Hopeless& hopeless, const Problem& problem, const Scales& scales, Found& found) {
  found.x = problem.start();
  found.starts = found.agreed = found.planned_starts = 1;
  found.assessment = assess(problem, scales, found.x, false);
  found.assessment.verdict = Verdict::Infeasible;
  found.assessment.blamed = {hopeless.limit};
  found.assessment.reason = fmt::format("{} cannot be met: {}", hopeless.limit, hopeless.why);
  found.assessment.global = hopeless.global;
}

/// Judges the one design of a problem in which nothing varies.
void judge_alone(const Problem& problem, Trail& trail) {
  trail.scales = scales(problem, {});
  Found& found = trail.found;
  found.starts = found.agreed = 1;
  found.status = Status::Solved;
  found.assessment = assess(problem, trail.scales, {}, true);
  if (is_feasible(found.assessment)) return;
  const Assessment least = assess_least_violation(problem, trail.scales, {});
  if (least.verdict == Verdict::Infeasible) {
    found.assessment = least;
  } else if (const auto hopeless = hopeless_limit(problem, trail.scales)) {
    blame(*hopeless, problem, trail.scales, found);
  }
}

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

/// Searches from one start, whatever came of the others.
FromStart search_one(const Setting& setting, int number, FirstStart first) {
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
    trail.scales = scales(setting.problem, start);
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

/// Of what has been told the functions; after a stop it is not needed, and left out.
void find_told(const Setting& setting, Trail& trail) {
  try {
    find_functions(setting.problem, trail.told);
  } catch (const Interrupted&) {
    trail.told.clear();
  }
}

/// What the model threw in the search from a start ends the search.
struct ModelThrew {};

/// Searches from one start or several; of the first of them what is known is taken. `ends` gets the
/// objective where each start ended, infinite where that is no design.
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
    FromStart start = is_known ? std::move(known[at]) : search_one(setting, number, first);
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

/// Whether the answer is where the search began, or says itself that its conditions may hold by
/// chance, and no lower bound speaks for it.
bool is_doubtful(const Problem& problem, const Scales& scales, const Found& found) {
  const Assessment& a = found.assessment;
  if (!is_feasible(a) || a.global) return false;
  if (!a.sign.empty()) return true;
  const std::vector<double> start = problem.start();
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Variable& v = problem.variables[i];
    const bool inside = v.lower == v.upper || (start[i] > v.lower && start[i] < v.upper);
    if (!inside || std::abs(found.x[i] - start[i]) > 1e-9 * scales.variables[i]) return false;
  }
  return true;
}

/// A search that began once begins again elsewhere.
void search_elsewhere(WatchedProblem& watched, const Setting& setting, Trail& trail) {
  constexpr int kStarts = 4;  // the start and three other places
  if (trail.found.starts > 1 || setting.deadline.passed()) return;
  if (!is_doubtful(setting.problem, trail.scales, trail.found)) return;
  const auto more = starts(setting.problem, kStarts, setting.options.seed);
  for (std::size_t i = 1; i < more.size() && !setting.deadline.passed(); ++i) {
    search_from_start(more[i], setting, trail);
  }
  prove_best(watched, setting, trail);
}

/// How many starts ended at designs as good as the best.
int agreed(const std::vector<double>& ends, double best, double size) {
  return static_cast<int>(std::count_if(ends.begin(), ends.end(), [&](double end) {
    return std::abs(end - best) <= 1e-6 * std::max(std::abs(best), size);
  }));
}

/// Of a search from several starts: where the box holds a better design than all of them led to, it
/// goes on from there. Where a look takes a search over the cycle at each place, only if most of
/// the starts ended elsewhere than at the best, or at no optimum.
void search_around(const Setting& setting, const std::vector<double>& ends, Trail& trail) {
  constexpr int kTimes = 3;  // each time a better design was found, and searched from
  const OptimiseOptions& how = setting.options;
  const bool is_wide = !how.starts && how.divides && count_of_starts(setting) > 1;
  const Assessment& a = trail.found.assessment;
  if (!is_wide || trail.is_infeasible()) return;
  const int alike = agreed(ends, a.objective.value, trail.scales.objective);
  const bool is_agreed = is_settled(a) && 2 * alike > static_cast<int>(ends.size());
  const bool is_line = setting.problem.variables.size() == 1;  // which the look fills densely
  if (is_agreed && !is_line && !is_quick(setting.problem)) return;
  for (int i = 0; i < kTimes && !setting.deadline.passed(); ++i) {
    if (is_settled(a) && (a.is_global || is_near_limit(setting.original, a))) return;
    const auto x = better_elsewhere(setting, trail);
    if (!x) return;
    const Scales there = scales(setting.problem, *x);
    const Assessment own = assess(setting.problem, there, *x, false);
    if (!is_feasible(own)) return;
    trail.take(*x, there, own);
    search_from_start(*x, setting, trail);
  }
}

/// An answer is never worse than the design that the problem states as its start: a search may run
/// away from it, where functions have kinks, and come back to none as good.
void keep_start(const Setting& setting, Trail& trail) {
  const Problem& problem = setting.problem;
  const Found& found = trail.found;
  const std::vector<double> start = problem.start();
  if (found.x == start || setting.deadline.passed()) return;
  const double sign = problem.objective().sense == Sense::Minimize ? 1 : -1;
  const double gain =
      sign * (found.assessment.objective.value - objective_value(problem.objective(), start));
  if (is_feasible(found.assessment) && !(gain > 0)) return;  // as nearly always
  const Scales there = scales(problem, start);
  const Assessment own = assess(problem, there, start, false);
  if (!is_feasible(own) || !better(problem, own, found.assessment)) return;
  trail.take(start, there, assess(problem, there, start, setting.proves()));
}

/// Says what the search adds to the reason of the assessment.
std::string words_of_search(const Setting& setting, const Trail& trail) {
  const Found& found = trail.found;
  const Assessment& a = found.assessment;
  const Deadline& deadline = setting.deadline;
  if (found.starts < found.planned_starts) {
    return fmt::format("{} after {} of {} starts; {}", deadline.reason(), found.starts,
                       found.planned_starts, a.reason);
  }
  if (deadline.passed() && a.verdict != Verdict::Certified)
    return fmt::format("{}; {}", deadline.reason(), a.reason);
  if (a.verdict == Verdict::Feasible && trail.is_at_edge()) return words_at_edge(setting, trail);
  const bool unsolved =
      a.verdict == Verdict::Feasible && setting.proves() && found.status != Status::Solved;
  if (a.verdict == Verdict::Failed || unsolved)
    return fmt::format("{} ({}: {})", a.reason, found.solver, trail.message);
  return a.reason;
}

void conclude_search(const Setting& setting, const std::vector<double>& ends, Trail& trail) {
  Found& found = trail.found;
  found.agreed += agreed(ends, found.assessment.objective.value, trail.scales.objective);
  Assessment& a = found.assessment;
  const bool is_looked_at = setting.proves() && !setting.deadline.passed();
  if (is_looked_at && a.verdict == Verdict::Feasible && !is_settled(a)) {
    const std::string unbounded = unbounded_words(setting.problem, found.x);
    if (!unbounded.empty()) a.reason = fmt::format("{}; {}", unbounded, a.reason);
  }
  a.reason = words_of_search(setting, trail);
}

/// Judges what needs no search, be it that none is possible; false where one is wanted.
bool is_judged_without_search(const Setting& setting, Trail& trail) {
  const Problem& problem = setting.problem;
  if (problem.variables.empty()) {
    judge_alone(problem, trail);
    return true;
  }
  trail.scales = scales(problem, problem.start());
  if (setting.options.solver != "auto") {  // of which the plan takes what accepts the problem
    const Solver& first = *setting.plan.solvers.front();
    const auto why = refusal(problem, trail.scales, problem.start(), first);
    if (why) {
      trail.fail(*why);
      return true;
    }
  }
  const auto hopeless = hopeless_limit(problem, trail.scales);
  if (hopeless) blame(*hopeless, problem, trail.scales, trail.found);
  return hopeless.has_value();
}

/// Where no design with numbers was found: there is none, if the model's own conditions show that.
void end_without_numbers(const Setting& setting, Trail& trail) {
  trail.fail(undefined_at(setting.original, setting.problem.start(), "the start"));
  const auto none = none_possible(setting.original);
  if (!none) return;
  Assessment& assessment = trail.found.assessment;
  assessment.verdict = Verdict::Infeasible;
  assessment.reason = fmt::format("{}; {}", *none, assessment.reason);
  assessment.global = *none;
}

/// Carries out all stages in turn.
void search(WatchedProblem& watched, const Setting& setting, Trail& trail,
            std::vector<double>& ends, std::vector<FromStart> known) {
  const Problem& problem = setting.problem;
  Found& found = trail.found;
  // A start that was searched from has shown that there is something to search for; after a stop
  // there is no time to look once more.
  const bool is_begun = !known.empty() && known.front().end != StartEnd::NotBegun;
  if (!is_begun && is_judged_without_search(setting, trail)) return;
  search_starts(setting, trail, ends, std::move(known));
  if (is_quick(problem)) search_around(setting, ends, trail);
  if (!has_numbers(found)) seek_numbers(setting, trail);
  if (trail.is_infeasible()) return conclude_search(setting, ends, trail);
  if (!has_numbers(found)) return end_without_numbers(setting, trail);
  search_along_edge(setting, trail);
  if (!is_quick(problem) && !trail.is_at_edge()) search_around(setting, ends, trail);
  const bool may_be_endless = trail.unbounded && !trail.is_at_edge();
  if (may_be_endless && trail.is_within_limits() && !is_settled(found.assessment)) {
    found.status = Status::Unbounded;
    return trail.fail("the objective improves without bound: a limit is missing");
  }
  prove_best(watched, setting, trail);
  search_elsewhere(watched, setting, trail);
  keep_from_edge(setting, trail);
  keep_start(setting, trail);
  if (!trail.is_infeasible()) conclude_search(setting, ends, trail);
}

/// Ends a search that was cut short: with the best design so far, judged soon and without proofs.
void end_in_haste(const Setting& setting, Trail& trail) {
  const Deadline rest(1 + 0.05 * setting.deadline.spent(), nullptr);  // s
  const ProofTime time(rest);
  const Problem plain = remembered(setting.original);
  const bool sized = trail.scales.constraints.size() == plain.constraints.size();
  Found& found = trail.found;
  if (!found.x.empty()) judge_in_haste(plain, found.x, found.assessment);
  const auto take = [&](const std::vector<double>& x) {
    Assessment a = sized ? assess_in_haste(plain, trail.scales, x) : assess_in_haste(plain, x);
    if (!found.x.empty() && !better(plain, a, found.assessment)) return;
    found.x = x;
    found.assessment = std::move(a);
  };
  if (!trail.last.empty() && trail.last != found.x) take(trail.last);
  take(plain.start());
  if (trail.is_infeasible()) return;
  const bool late = setting.deadline.left().value_or(kInfinity) <= 1e-3;  // s
  found.status = late ? Status::TimeLimit : Status::Stopped;
}

}  // namespace

void check_solvers(const OptimiseOptions& options) {
  if (options.solver != "auto") find_solver(options.solver);
  for (const auto& [solver, native] : options.native) {
    check_native_options(find_solver(solver), native);
  }
}

int planned_starts(const Problem& problem, const OptimiseOptions& options) {
  const Deadline none({}, nullptr);
  return count_of_starts(
      {problem, problem, options, none, Depth::Node, plan(problem, options.solver)});
}

FromStart search_one_start(const Problem& problem, const OptimiseOptions& options,
                           const Deadline& deadline, int start, FirstStart first) {
  const WatchedProblem watched(interruptible(problem, deadline));
  const Setting setting{problem,  watched.problem(),  options,
                        deadline, Depth::Combination, plan(problem, options.solver)};
  Trail none;
  try {  // the first tells for all
    if (start == 0 && is_judged_without_search(setting, none))
      return {{}, kInfinity, StartEnd::NotBegun};
  } catch (const Interrupted&) {
    return {{}, kInfinity, StartEnd::CutShort};
  } catch (...) {  // the whole search comes upon it too
    return {{}, kInfinity, StartEnd::NotBegun};
  }
  return search_one(setting, start, first);
}

bool ends_search(const FromStart& start) {
  const Assessment& a = start.trail.found.assessment;
  const bool best_of_all = is_settled(a) && a.is_global;
  return best_of_all || start.trail.is_infeasible() || start.end != StartEnd::Itself;
}

Found search_continuous(const Problem& problem, const OptimiseOptions& options,
                        const Deadline& deadline, Depth depth, std::vector<FromStart> known) {
  WatchedProblem watched(interruptible(problem, deadline));
  const Setting setting{
      problem, watched.problem(), options, deadline, depth, plan(problem, options.solver)};
  Trail trail;
  trail.found.why_solver = setting.plan.why;
  trail.found.solver = setting.plan.solvers.front()->name();
  std::vector<double> ends;
  try {
    search(watched, setting, trail, ends, std::move(known));
  } catch (const Interrupted&) {
    try {
      end_in_haste(setting, trail);
      if (!trail.is_infeasible()) conclude_search(setting, ends, trail);
    } catch (...) {
      trail.fail(words_of(std::current_exception()));
    }
    return std::move(trail.found);
  } catch (const ModelThrew&) {  // the trail has the words
  } catch (...) {
    trail.thrown = words_of(std::current_exception());
  }
  if (!trail.thrown.empty() && !trail.is_within_limits()) trail.fail(trail.thrown);
  return std::move(trail.found);
}

Found cut_short(const Problem& problem, const std::vector<double>& x, const std::string& why) {
  Found found;
  found.x = x;
  found.assessment = assess_in_haste(remembered(problem), x);
  found.assessment.reason = fmt::format("{}; {}", why, found.assessment.reason);
  return found;
}

}  // namespace camlaw::optim
