// SPDX-License-Identifier: MIT
#include "problems/sweeps/optimum_point.h"

#include <algorithm>
#include <cmath>

#include "optim/pareto/costs.h"

namespace camlaw::problems {

std::vector<std::size_t> options_at_start(const BoundProblem& bound) {
  std::vector<std::size_t> options;
  for (const optim::Choice& choice : bound.choices()) options.push_back(choice.start);
  return options;
}

std::optional<SplitDesign> split_of(const BoundProblem& bound, optim::Design recorded) {
  const auto& choices = bound.choices();
  if (recorded.size() < choices.size()) return {};
  const std::size_t count = recorded.size() - choices.size();
  SplitDesign split;
  split.x.assign(recorded.begin(), recorded.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const double option = recorded[count + i];
    const bool is_one = option >= 0 && option == std::floor(option) &&
                        option < static_cast<double>(choices[i].options.size());
    if (!is_one) return {};
    split.options.push_back(static_cast<std::size_t>(option));
  }
  return split;
}

optim::Problem as_recorded(optim::Problem problem, const std::vector<optim::Choice>& choices) {
  for (const optim::Choice& choice : choices) {
    optim::Variable option;
    option.name = choice.name;
    option.lower = 0;
    option.upper = static_cast<double>(choice.options.size()) - 1;
    option.start = static_cast<double>(choice.start);
    option.integer = true;
    problem.variables.push_back(std::move(option));
  }
  return problem;
}

std::optional<optim::Problem> beginning_at(const BoundProblem& bound, optim::Design recorded) {
  if (!bound.choices().empty()) return {};
  optim::Problem problem = bound.problem({});
  if (problem.variables.size() != recorded.size()) return {};
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    optim::Variable& v = problem.variables[i];
    v.start = std::clamp(recorded[i], v.lower, v.upper);
    if (v.integer) v.start = std::round(v.start);
  }
  return problem;
}

optim::Outcome outcome_of(const optim::Optimum& optimum, std::size_t part, long evaluations) {
  const optim::Problem& problem = optimum.problem;
  const optim::Found& found = optimum.found;
  const optim::Assessment& a = found.assessment;
  optim::Outcome outcome;
  outcome.evaluations = evaluations;
  outcome.is_global = a.global.has_value();
  const bool no_design = found.x.empty() && !problem.variables.empty();
  outcome.infeasible = a.verdict == optim::Verdict::Infeasible;
  if (outcome.infeasible || a.verdict == optim::Verdict::Failed || no_design) {
    outcome.failure = a.reason;
    return outcome;
  }
  optim::FrontPoint point;
  point.part = part;
  point.x.assign(found.x.begin(), found.x.end());
  point.costs = optim::costs(problem, point.x);
  for (std::size_t i = 0; i < point.costs.size(); ++i) {
    point.objectives.push_back(optim::as_cost(problem.objectives[i], point.costs[i]));
  }
  point.weights = {1};
  point.verdict = a.verdict;
  point.reason = a.reason;
  point.is_global = a.global.has_value();
  point.solver = found.solver;
  for (const optim::LimitReport& limit : a.limits) {
    point.limits.push_back({limit.name, limit.unit, limit.margin, limit.worst_angle, limit.met,
                            limit.proved, limit.multiplier});
  }
  for (const std::size_t option : optimum.options) {
    point.x.push_back(static_cast<double>(option));
  }
  outcome.points = {std::move(point)};
  return outcome;
}

optim::Outcome evaluated(const BoundProblem& bound, std::size_t part) {
  const std::vector<std::size_t> options = options_at_start(bound);
  const optim::Problem problem = bound.problem(options);
  optim::FrontPoint point = optim::looked_at(problem, part, problem.start());
  for (const std::size_t option : options) point.x.push_back(static_cast<double>(option));
  optim::Outcome outcome;
  outcome.evaluations = 1;
  outcome.points = {std::move(point)};
  return outcome;
}

}  // namespace camlaw::problems
