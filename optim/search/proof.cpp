// SPDX-License-Identifier: MIT
#include "optim/search/proof.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optim/cycle/remembered.h"
#include "optim/cycle/watched.h"
#include "optim/search/feasible.h"
#include "optim/search/rescaling.h"
#include "optim/search/told.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

bool prove_number(Response& response, Design x) {
  if (response.is_curve() || !response.function().is_searched()) return false;
  const Function proved = response.function().proved();
  if (proved.value(x) == response.function().value(x)) return false;
  response.measure = proved;
  return true;
}

bool is_proved(const Problem& problem, const Found& found) {
  const Assessment& a = found.assessment;
  const Response& sought = problem.objective().response;
  const bool searched =
      sought.is_curve() ? a.objective.angle.has_value() : sought.function().is_searched();
  if (!searched) return is_feasible(a);
  if (!std::isfinite(a.objective.proved.upper - a.objective.proved.lower)) return false;
  return is_feasible(a) &&
         (sought.is_curve() || a.objective.value == sought.function().value(found.x));
}

/// The method that goes on from a design that was found: a sharp one, if the plan begins with one,
/// since others take far longer; else the plan's last.
const Solver& finisher(const Setting& setting) {
  const Solver& first = *setting.plan.solvers.front();
  return first.is_sharp() ? first : *setting.plan.solvers.back();
}

/// Conditions that held in the scales of a search may not hold in those of the design it led to:
/// then the search goes on from there. Where that leads away, scales are once more the design's
/// own: from the slope of a steep function they may be orders of magnitude off.
void settle_in_own_scales(const Setting& setting, Trail& trail) {
  if (!trail.is_within_limits()) return;
  Assessment& best = trail.found.assessment;
  Scales own = scales(setting.problem, trail.found.x);
  const bool known = is_settled(best) && !differ(own, trail.scales);
  trail.scales = std::move(own);
  if (known) return;
  best = assess(setting.problem, trail.scales, trail.found.x, false, told_as(trail.told));
  const Solver& solver = finisher(setting);
  if (is_settled(best) || solver.is_global() || setting.deadline.passed()) return;
  Reached reached;
  const std::vector<double> from = trail.found.x;
  attempt(from, solver, setting, trail, reached);
  const bool has_moved = trail.found.x != from;
  if (has_moved && trail.is_within_limits()) trail.scales = scales(setting.problem, trail.found.x);
}

/// Judges the best design, with proofs. What its solve has told may not do where other designs and
/// other scales were looked at since: then a linear problem is solved once more from there.
Assessment judged_best(const Setting& setting, const Trail& trail) {
  const auto with = [&](const Teller& told) {
    return assess(setting.problem, trail.scales, trail.found.x, true, told);
  };
  Assessment judged = with(told_as(trail.told));
  const bool wanting = is_feasible(judged) && !judged.global;
  if (!is_linear(setting.problem) || !wanting || setting.deadline.passed()) return judged;
  Assessment again = with(teller_at(setting.problem, trail.scales, trail.found.x));
  return again.verdict == Verdict::Certified ? again : judged;
}

/// Searches from the best design on, now that more is known of the curves.
void search_again(const Setting& setting, Trail& trail) {
  const Solver& solver = finisher(setting);
  const Attempt again = attempt(trail.found.x, solver, setting, trail, Aim::Optimum);
  if (!again.x.empty()) {
    trail.found.x = again.x;
    trail.told = again.told;
    trail.found.status = again.status;
    trail.found.solver = solver.name();
    trail.message = again.message;
  }
  trail.found.assessment =
      assess(setting.problem, trail.scales, trail.found.x, false, told_as(trail.told));
}

}  // namespace

WatchedProblem::WatchedProblem(Problem plain)
    : plain_(std::move(plain)),
      problem_(remembered(plain_)),
      angles_(1 + problem_.constraints.size()) {}

bool WatchedProblem::watch(std::size_t index, double angle, const Response& plain,
                           Response& response) {
  std::vector<double>& angles = angles_[index];
  if (std::find(angles.begin(), angles.end(), angle) != angles.end()) return false;
  angles.push_back(angle);
  response = remembered(watched(plain, angles));
  return true;
}

bool WatchedProblem::learn(Design x, const Assessment& a) {
  Response& sought = problem_.objectives.front().response;
  bool any = prove_number(sought, x);
  if (a.objective.angle && std::isinf(a.objective.proved.upper - a.objective.proved.lower))
    any |= watch(0, *a.objective.angle, plain_.objective().response, sought);
  for (std::size_t i = 0; i < a.limits.size(); ++i) {
    Response& limited = problem_.constraints[i].response;
    any |= prove_number(limited, x);
    if (a.limits[i].met || !a.limits[i].worst_angle) continue;
    any |= watch(i + 1, *a.limits[i].worst_angle, plain_.constraints[i].response, limited);
  }
  return any;
}

void prove_best(WatchedProblem& watched, const Setting& setting, Trail& trail) {
  // Each adds to what is watched the angles at which the proof of the round before failed.
  constexpr int kRounds = 10;
  Found& found = trail.found;
  Reached reached;
  for (int round = 0; !trail.is_infeasible(); ++round) {
    const bool is_judged = std::exchange(trail.is_judged, false);
    if (!is_judged) settle_in_own_scales(setting, trail);
    if (!trail.is_within_limits() && !setting.deadline.passed())
      find_feasible(setting, trail, reached);
    if (!trail.is_within_limits() || !setting.proves()) return;
    if (!is_judged) found.assessment = judged_best(setting, trail);
    if (is_proved(setting.problem, found) || setting.deadline.passed() || round == kRounds) return;
    if (!watched.learn(found.x, found.assessment)) return;
    search_again(setting, trail);
  }
}

}  // namespace camlaw::optim
