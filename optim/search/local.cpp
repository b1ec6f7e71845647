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
#include "optim/search/from_start.h"
#include "optim/search/hopeless.h"
#include "optim/search/interruptible.h"
#include "optim/search/look_around.h"
#include "optim/search/proof.h"
#include "optim/search/several_starts.h"
#include "optim/search/unbounded.h"
#include "optim/search/with_numbers.h"
#include "optim/search/without_value.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/limits_in_haste.h"
#include "optim/verdict/none_possible.h"
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
  if (!hopeless.global.empty()) found.assessment.global = hopeless.global;
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
  auto hopeless = hopeless_limit(problem, trail.scales);
  if (!hopeless) hopeless = limit_without_value(problem, setting.options.seed, Asked::Before);
  if (hopeless) blame(*hopeless, problem, trail.scales, trail.found);
  return hopeless.has_value();
}

/// Blames a limit of whose response proofs have come upon a place without a value, such as a narrow
/// part of a range, at the answer and at a few other designs: no search is led there.
void blame_without_value(const Setting& setting, Trail& trail) {
  constexpr int kDesigns = 12, kLeast = 8;  // fewer may all lie where the model has no values
  Assessment& a = trail.found.assessment;
  if (a.verdict != Verdict::Failed || !setting.proves() || setting.deadline.passed()) return;
  const auto none = std::ranges::find_if(
      a.limits, [](const LimitReport& limit) { return std::isnan(limit.value); });
  if (none == a.limits.end()) return;
  const Problem& problem = setting.problem;
  int checked = 1;  // the answer itself
  for (const std::vector<double>& x : starts(problem, kDesigns, setting.options.seed)) {
    // Where the objective has no value either, the design says nothing of the limit.
    if (x == trail.found.x || std::isnan(objective_value(problem.objective(), x))) continue;
    const auto limits = limit_reports(problem, scales(problem, x), x, true);
    if (!std::isnan(limits[static_cast<std::size_t>(none - a.limits.begin())].value)) return;
    ++checked;
  }
  if (checked < kLeast) return;
  a.verdict = Verdict::Infeasible;
  a.blamed = {none->name};
  a.reason = fmt::format(
      "{} cannot be met: at each of the {} designs that were checked with proofs there is a place "
      "where it has no value",
      none->name, checked);
}

/// Where no design with numbers was found: there is none, if the model's own conditions show that,
/// or if a limit's response has no value anywhere.
void end_without_numbers(const Setting& setting, Trail& trail) {
  Assessment& assessment = trail.found.assessment;
  const bool is_within =
      !trail.found.x.empty() && !assessment.limits.empty() && meets_limits(assessment);
  trail.fail(is_within
                 ? undefined_at(setting.original, trail.found.x, "a design that meets the limits")
                 : undefined_at(setting.original, setting.problem.start(), "the start"));
  if (const auto none = none_possible(setting.original)) {
    assessment.verdict = Verdict::Infeasible;
    assessment.reason = fmt::format("{}; {}", *none, assessment.reason);
    assessment.global = *none;
    return;
  }
  const auto without = limit_without_value(setting.problem, setting.options.seed, Asked::After);
  if (without) return blame(*without, setting.problem, trail.scales, trail.found);
  const std::string objective = objective_without_value(setting.problem, setting.options.seed);
  if (!objective.empty()) trail.fail(objective);
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
  blame_without_value(setting, trail);
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
  return search_one(setting, start, first, none.scales.variables.empty() ? nullptr : &none.scales);
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
