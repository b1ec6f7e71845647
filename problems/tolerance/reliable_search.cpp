// SPDX-License-Identifier: MIT
#include "problems/tolerance/reliable_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "optim/cycle/scales.h"
#include "optim/verdict/limits.h"
#include "problems/statement/impossible_values.h"
#include "problems/statement/ranges.h"

namespace camlaw::problems {
namespace {

/// The problem with shares that ask for more where a limit is not reached (TV11); with more to
/// spare in each round, as between few parts the share that is reached may not follow.
ProblemStatement asking_for_more(ProblemStatement statement, const ReachedReliability& reached,
                                 int round) {
  // A round asks for at least 2 % fewer failures than follow from the last one (TV11), but not for
  // less than an eighth of those allowed, which few parts cannot show.
  constexpr double kSpare = 0.98, kLeast = 0.125;
  for (const ReachedShare& own : reached.limits) {
    if (own.reach == IsReached::Yes) continue;
    ConstraintStatement& limit = statement.constraints[own.limit];
    const double before = 1 - limit.searched_share.value_or(*limit.reliability);
    const double spare = std::pow(kSpare, std::pow(3.0, std::min(round, 3)));
    const double after = spare * before * (1 - own.wanted) / (1 - own.between.lower);
    limit = searched_at(statement, limit,
                        1 - std::min(std::max(after, kLeast * (1 - own.wanted)), before));
  }
  return statement;
}

/// The same design in the problem as it is stated.
optim::Optimum restated(const BoundProblem& bound, optim::Optimum found) {
  found.problem = bound.problem(found.options);
  optim::Assessment& own = found.found.assessment;
  const optim::Scales scales = optim::scales(found.problem, found.found.x);
  const auto prices =
      std::exchange(own.limits, optim::limit_reports(found.problem, scales, found.found.x, false));
  for (std::size_t i = 0; i < own.limits.size() && i < prices.size(); ++i) {
    own.limits[i].multiplier = prices[i].multiplier;
  }
  own.global.reset();
  own.best_possible.reset();
  own.is_global = false;
  return found;
}

/// The design that is left is not the best that a search finds: this one had no time to.
void say_stopped(const optim::Deadline& clock, optim::Assessment& assessment) {
  assessment.reason = fmt::format(
      "{} before a design was found that reaches every reliability; of the last one, {}",
      clock.reason(), assessment.reason);
}

optim::Deadline clock_of(const optim::OptimiseOptions& options, const optim::Optimum& optimum) {
  return {options.time_limit, options.stop, options.spent + optimum.wall_s};
}

}  // namespace

ReachedReliability judge_optimum(const BoundProblem& bound, const optim::OptimiseOptions& options,
                                 optim::Optimum& optimum) {
  say_impossible(bound, optimum);
  if (!optim::is_feasible(optimum.found.assessment)) return {};
  const ReachedReliability reached =
      reached_by(bound.at(optimum.options, optimum.found.x), clock_of(options, optimum));
  hold_to(reached, optimum.found.assessment);
  return reached;
}

ReachedReliability search_until_reached(
    const BoundProblem& bound, const optim::OptimiseOptions& options, optim::Optimum& optimum,
    const std::function<void(const std::string& stage)>& begins) {
  // Of 240 random linear problems all reached what was asked for with these.
  constexpr int kMost = 6;
  say_impossible(bound, optimum);
  if (!optim::is_feasible(optimum.found.assessment)) return {};
  const optim::Deadline clock = clock_of(options, optimum);
  const auto says = [&](const std::string& stage) {
    if (begins) begins(stage);
  };
  const auto judged = [&](const optim::Optimum& one) {
    return reached_by(bound.at(one.options, one.found.x), clock);
  };
  if (is_judged(bound.statement())) says("parts of other draws are judged");
  ReachedReliability reached = judged(optimum);
  ProblemStatement statement = bound.statement();
  for (int k = 0; k < kMost && reached.cut_short.empty() && !reached.all(); ++k) {
    statement = asking_for_more(std::move(statement), reached, k);
    optim::OptimiseOptions again = options;
    again.spent = clock.spent();
    says(fmt::format("reliability, round {}", k + 1));
    optim::Optimum found = optim::optimise(BoundProblem(statement).space(), again);
    if (!optim::is_feasible(found.found.assessment)) break;
    found = restated(bound, std::move(found));
    found.found.add_work(optimum.found);
    found.wall_s += optimum.wall_s;
    says(fmt::format("reliability, round {}: parts of other draws are judged", k + 1));
    ReachedReliability next = judged(found);
    if (!next.cut_short.empty()) break;
    optimum = std::move(found);
    reached = std::move(next);
  }
  const bool is_known = reached.cut_short.empty();  // else the fault tells why it is not
  hold_to(reached, optimum.found.assessment);
  if (is_known && !reached.all() && clock.passed()) say_stopped(clock, optimum.found.assessment);
  return reached;
}

}  // namespace camlaw::problems
