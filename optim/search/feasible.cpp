// SPDX-License-Identifier: MIT
#include "optim/search/feasible.h"

#include <cmath>
#include <utility>

#include "optim/search/interruptible.h"
#include "optim/search/least_violating.h"
#include "optim/search/local.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Holds a design of least violation, and what is to be said of it.
struct Least {
  Attempt attempt;  ///< without a design where no search led to one in time
  Assessment blame;
};

Least least_violation_as_posed(Design start, const Setting& setting, Trail& trail) {
  Least least;
  for (const Solver* solver : least_violation_plan(setting.problem)) {
    least.attempt = attempt(start, *solver, setting, trail, Aim::LeastViolation);
    if (least.attempt.x.empty() || setting.deadline.passed()) return {};
    least.blame = assess_least_violation(setting.problem, trail.scales, least.attempt.x,
                                         told_as(least.attempt.told));
    if (is_feasible(least.blame) || least.blame.verdict == Verdict::Infeasible) break;
  }
  return least;
}

bool is_told(const Least& least) {
  return is_feasible(least.blame) || least.blame.verdict == Verdict::Infeasible;
}

/// The way to the least violation may pass a limit beyond which other responses have no value, and
/// end there. A search that does not pass such limits may then show that no design is left.
Least least_violation_from(Design start, const Setting& setting, Trail& trail) {
  Least least = least_violation_as_posed(start, setting, trail);
  if (is_told(least) || setting.deadline.passed()) return least;
  const std::optional<Problem> strict = with_strict_edges(setting.problem);
  if (!strict) return least;
  const Setting within{setting.original, *strict,       setting.options,
                       setting.deadline, setting.depth, setting.plan};
  // Where the way has ended there may be no slopes; the stated start is away from there.
  const bool has_values = std::isfinite(worst_violation(least.blame.limits));
  const bool goes_on = has_values && !least.attempt.x.empty();
  const std::vector<double> end =
      goes_on ? least.attempt.x : std::vector(start.begin(), start.end());
  for (const std::vector<double>& from : {end, setting.original.start()}) {
    Least other = least_violation_as_posed(from, within, trail);
    if (is_told(other)) return other;
    if (setting.deadline.passed()) break;
  }
  return least;
}

/// Takes the place itself, where it meets every limit, else where a search from it leads.
Least least_violation_at(const std::vector<double>& x, const Setting& setting, Trail& trail) {
  try {
    Least least;
    least.blame = assess(setting.problem, trail.scales, x, false);
    if (!is_feasible(least.blame)) return least_violation_from(x, setting, trail);
    least.attempt.x = x;
    least.attempt.status = Status::Solved;
    least.attempt.message = "a design within the bounds was found that meets every limit";
    return least;
  } catch (...) {
    if (is_interruption(std::current_exception())) throw;
    return {};
  }
}

/// Where nothing shows that the limits leave no design at all, the least violation that was found
/// may be one of several: searches from elsewhere, until one comes to a design within the limits.
/// What the model throws there says nothing of what was found. In the nodes of a search over whole
/// variables there is no such look.
Least least_violation_of_all(Least least, const Setting& setting, Trail& trail) {
  // Each takes a search; the best of 384 places that lie apart come first.
  constexpr std::size_t kTried = 4;
  constexpr double kGain = 1e-6;  // of the scales: a smaller gain is what the solver leaves
  if (least.blame.global || setting.depth == Depth::Node) return least;
  const std::string thrown = trail.thrown;
  for (const auto& x : least_violating(setting.problem, trail.scales, least.attempt.x, kTried,
                                       setting.options.seed)) {
    if (is_feasible(least.blame) || setting.deadline.passed()) break;
    Least other = least_violation_at(x, setting, trail);
    trail.thrown = thrown;
    if (other.attempt.x.empty()) continue;
    const double gain = largest_violation(setting.problem, trail.scales, least.attempt.x) -
                        largest_violation(setting.problem, trail.scales, other.attempt.x);
    // Where a limit has no value a design violates the others by less, but is not nearer.
    const bool has_values = std::isfinite(worst_violation(other.blame.limits)) ||
                            !std::isfinite(worst_violation(least.blame.limits));
    if (is_feasible(other.blame) || (has_values && gain > kGain)) least = std::move(other);
  }
  if (setting.deadline.passed() && !is_feasible(least.blame)) {  // not everywhere
    least.blame.verdict = Verdict::Failed;
    least.blame.reason = "no design was found that meets every limit";
  }
  return least;
}

/// Begins the problem at a design, and holds the variables that stand at their bounds there; none
/// where no variable does.
std::optional<Problem> held_at_bounds(Problem problem, Design x, const Scales& scales) {
  constexpr double kAt = 1e-7;  // of a typical change: as near as solvers come
  bool any = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Variable& v = problem.variables[i];
    v.start = x[i];
    if (v.lower == v.upper) continue;
    for (const double bound : {v.lower, v.upper}) {
      if (!(std::abs(x[i] - bound) <= kAt * scales.variables[i])) continue;
      v.lower = v.upper = v.start = bound;
      any = true;
      break;
    }
  }
  return any ? std::optional(std::move(problem)) : std::nullopt;
}

/// Where a law loses a phase at a variable's bound, curves are others than beside it, and a search
/// that leaves the bound does not come back: so one is made that holds the variables which stand at
/// theirs.
void search_along_bounds(Design x, const Setting& setting, Trail& trail, Reached& reached) {
  const auto along = held_at_bounds(setting.original, x, trail.scales);
  if (!along || setting.deadline.passed()) return;
  OptimiseOptions once = setting.options;
  once.solver = "auto";
  once.starts = 1;
  once.progress = {};
  once.candidate = {};
  const Found found = search_continuous(*along, once, setting.deadline, Depth::Node);
  trail.found.add_work(found);
  if (!is_feasible(found.assessment)) return;
  Attempt there;
  there.x = found.x;
  there.status = found.status;
  there.message = "the variables at their bounds were held fixed";
  consider(there, find_solver(found.solver), setting, trail, reached);
}

}  // namespace

void find_feasible(const Setting& setting, Trail& trail, Reached& reached) {
  Assessment& best = trail.found.assessment;
  Least least = least_violation_from(trail.found.x, setting, trail);
  if (least.attempt.x.empty()) return;
  if (!is_feasible(least.blame)) least = least_violation_of_all(std::move(least), setting, trail);
  if (!is_feasible(least.blame)) {
    if (worst_violation(least.blame.limits) < worst_violation(best.limits) ||
        least.blame.verdict == Verdict::Infeasible) {
      best = least.blame;
      trail.found.x = least.attempt.x;
    }
    return;
  }
  least.attempt.told.clear();  // it is of the least violation
  consider(least.attempt, ipopt_solver(), setting, trail, reached);
  best.kkt_residual = kInfinity;
  const std::vector<const Solver*> solvers =
      is_linear(setting.problem)
          ? plan(setting.problem, "auto").solvers
          : std::vector<const Solver*>{&find_solver("slsqp"), &ipopt_solver()};
  for (const Solver* solver : solvers) {
    if (!is_settled(best)) attempt(least.attempt.x, *solver, setting, trail, reached);
  }
  if (!is_settled(best)) search_along_bounds(least.attempt.x, setting, trail, reached);
}

}  // namespace camlaw::optim
