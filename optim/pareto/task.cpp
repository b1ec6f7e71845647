// SPDX-License-Identifier: MIT
#include "optim/pareto/task.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "optim/cycle/scales.h"
#include "optim/pareto/costs.h"
#include "optim/pareto/part_front.h"
#include "optim/pareto/scout.h"
#include "optim/pareto/shifted.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// The problem that a task states; the number of limits that it adds to the problem's own.
struct Stated {
  Problem problem;
  std::vector<std::size_t> of_objective;  ///< of each added limit, the objective behind it
};

Stated bounded(const Problem& multi, const Task& task) {
  Stated stated{multi.alone(task.sought), {}};
  for (std::size_t i = 0; i < multi.objectives.size(); ++i) {
    if (i == task.sought || i >= task.bounds.size() || std::isinf(task.bounds[i])) continue;
    stated.problem.constraints.push_back(at_most(multi.objectives[i], task.bounds[i]));
    stated.of_objective.push_back(i);
  }
  return stated;
}

/// Least t with every cost at most origin + t * direction (Pascoletti and Serafini 1984).
Stated toward(const Problem& multi, const Task& task) {
  Stated stated{multi.alone(0), {}};
  Problem& problem = stated.problem;
  const std::size_t t = problem.variables.size();
  Variable distance;
  distance.name = "distance along the direction";
  distance.scale = 1;
  problem.variables.push_back(distance);
  problem.objectives = {{{"distance", "1", variable_function(t)}}};
  for (std::size_t i = 0; i < multi.objectives.size(); ++i) {
    const Objective& objective = multi.objectives[i];
    const double slope = task.direction[i];
    const bool from_above = objective.sense == Sense::Minimize;
    const auto add = [&](bool upper) {
      Constraint limit;
      limit.response = shifted(objective.response, upper ? -slope : slope, t);
      (upper ? limit.upper : limit.lower) = upper ? task.origin[i] : -task.origin[i];
      problem.constraints.push_back(std::move(limit));
      stated.of_objective.push_back(i);
    };
    add(from_above);
    if (objective.part == Part::Magnitude) add(!from_above);
  }
  return stated;
}

/// The distance that a design needs.
double distance_of(const Problem& multi, const Task& task, Design x) {
  const std::vector<double> cost = costs(multi, x);
  double t = -kInfinity;
  for (std::size_t i = 0; i < cost.size(); ++i) {
    t = std::max(t, (cost[i] - task.origin[i]) / task.direction[i]);
  }
  return t;
}

void start_at(Problem& problem, Design x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    Variable& v = problem.variables[i];
    v.start = std::clamp(x[i], v.lower, v.upper);
    if (v.integer) v.start = std::round(v.start);
  }
}

std::vector<Standing> standings(const std::vector<LimitReport>& limits, std::size_t count) {
  std::vector<Standing> result;
  for (std::size_t i = 0; i < std::min(count, limits.size()); ++i) {
    const LimitReport& limit = limits[i];
    result.push_back({limit.name, limit.unit, limit.margin, limit.worst_angle, limit.met,
                      limit.proved, limit.multiplier});
  }
  return result;
}

FrontPoint point_of(const Problem& multi, std::size_t part, Design x) {
  FrontPoint point;
  point.part = part;
  point.x.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(multi.variables.size()));
  point.costs = costs(multi, point.x);
  for (std::size_t i = 0; i < point.costs.size(); ++i) {
    point.objectives.push_back(as_cost(multi.objectives[i], point.costs[i]));
  }
  return point;
}

/// The normal of the front: prices of the limits that the task has added.
std::vector<double> weights_of(const Problem& multi, const Stated& stated, const Task& task,
                               const std::vector<LimitReport>& limits) {
  std::vector<double> weights(multi.objectives.size(), 0.0);
  if (task.kind == Task::Kind::Bounded) weights[task.sought] = 1;
  for (std::size_t k = 0; k < stated.of_objective.size(); ++k) {
    weights[stated.of_objective[k]] += limits.at(multi.constraints.size() + k).multiplier;
  }
  return weights;
}

bool is_certified(const Found& found) { return found.assessment.verdict == Verdict::Certified; }

/// From each start until one leads to an optimum that is the global one.
Found best_of_starts(Problem problem, const Problem& multi, const Task& task,
                     OptimiseOptions options, long& evaluations) {
  options.divides = false;  // a front has many points, and is not called global
  const auto search = [&] {
    Found found = optimise(problem, options).found;
    evaluations += found.evaluations;
    return found;
  };
  if (task.starts.empty()) return search();
  options.starts = 1;
  std::optional<Found> best;
  for (const auto& start : task.starts) {
    start_at(problem, start);
    if (task.kind == Task::Kind::Toward) {
      const double distance = distance_of(multi, task, start);
      problem.variables.back().start = std::isfinite(distance) ? distance : 1;
    }
    Found found = search();
    if (!best || better(problem, found.assessment, best->assessment)) best = std::move(found);
    if (best->assessment.global && is_certified(*best)) break;
  }
  return std::move(*best);
}

FrontPoint point_of(const Problem& multi, const Task& task, const Stated& stated,
                    const Found& found) {
  const Assessment& a = found.assessment;
  FrontPoint point = point_of(multi, task.part, found.x);
  point.verdict = a.verdict;
  point.reason = a.reason;
  point.is_global = a.global.has_value();
  point.limits = standings(a.limits, multi.constraints.size());
  point.weights = weights_of(multi, stated, task, a.limits);
  point.solver = found.solver;
  return point;
}

/// How near a cost may come to a limit of a task as to be held by it.
double slack_at(double cost, double limit) {
  // A solver leaves less between a cost and the limit that holds it.
  constexpr double kSlack = 1e-6;
  return kSlack * std::max(std::abs(cost), std::abs(limit - cost));
}

/// Whether a cost keeps clear of the limit that a task set it: the task's optimum does not tell how
/// small it could be.
bool is_free(const FrontPoint& point, const Task& task, std::size_t i) {
  constexpr double kSlack = 1e-6;  // a solver leaves less to a limit that does not hold
  if (task.kind == Task::Kind::Toward) return point.weights[i] * task.direction[i] <= kSlack;
  if (i == task.sought || i >= task.bounds.size()) return false;
  const double limit = task.bounds[i];
  return std::isfinite(limit) && limit - point.costs[i] > slack_at(point.costs[i], limit);
}

/// Costs that are free are sought with the others held, eased so that there is room.
FrontPoint pressed(FrontPoint point, const Problem& multi, const Task& task,
                   const OptimiseOptions& options, long& evaluations) {
  const std::vector<double>& limits = task.kind == Task::Kind::Toward ? task.origin : task.bounds;
  const auto room = [&](std::size_t k) {
    const double cost = point.costs[k];
    return slack_at(cost, k < limits.size() && std::isfinite(limits[k]) ? limits[k] : cost);
  };
  for (std::size_t i = 0; i < point.costs.size(); ++i) {
    if (!is_free(point, task, i)) continue;
    Task beside = as_good_as(point, task.part, i);
    for (std::size_t k = 0; k < point.costs.size(); ++k) beside.bounds[k] += room(k);
    beside.starts = {point.x};
    const Stated stated = bounded(multi, beside);
    const Found found = best_of_starts(stated.problem, multi, beside, options, evaluations);
    const bool sound = is_certified(found) || (point.verdict != Verdict::Certified &&
                                               found.assessment.verdict == Verdict::Feasible);
    if (!sound) {
      if (task.kind == Task::Kind::Bounded) point = doubted(std::move(point));
      continue;
    }
    FrontPoint better = point_of(multi, beside, stated, found);
    if (better.costs[i] < point.costs[i] - room(i)) point = std::move(better);
  }
  return point;
}

Outcome search(const Task& task, const Problem& multi, const OptimiseOptions& options) {
  Outcome outcome;
  const Stated stated =
      task.kind == Task::Kind::Toward ? toward(multi, task) : bounded(multi, task);
  const Found found = best_of_starts(stated.problem, multi, task, options, outcome.evaluations);
  const Assessment& a = found.assessment;
  outcome.is_global = a.global.has_value();
  if (a.verdict == Verdict::Infeasible) {
    outcome.infeasible = true;
    return outcome;
  }
  const bool no_design = found.x.empty() && !multi.variables.empty();
  if (a.verdict == Verdict::Failed || no_design) {
    outcome.failure = a.reason;
    return outcome;
  }
  outcome.points.push_back(
      pressed(point_of(multi, task, stated, found), multi, task, options, outcome.evaluations));
  return outcome;
}

void make_plain(double& value) {
  value = std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value + 0.0;
}

void make_plain(std::vector<double>& values) {
  for (double& value : values) make_plain(value);
}

Outcome plain(Outcome outcome) {
  for (FrontPoint& point : outcome.points) {
    for (auto* values : {&point.x, &point.objectives, &point.costs, &point.weights}) {
      make_plain(*values);
    }
    for (Standing& limit : point.limits) {
      make_plain(limit.margin);
      make_plain(limit.price);
      if (limit.angle) make_plain(*limit.angle);
    }
  }
  return outcome;
}

/// Points of several parts are compared: their objectives must be the same.
void check_same_objectives(const Problem& first, const Problem& other) {
  const auto same = [](const Objective& a, const Objective& b) {
    return a.response.name == b.response.name && a.sense == b.sense;
  };
  if (std::equal(first.objectives.begin(), first.objectives.end(), other.objectives.begin(),
                 other.objectives.end(), same)) {
    return;
  }
  throw std::invalid_argument(
      fmt::format("the problems '{}' and '{}' are on one front, but their objectives differ",
                  first.name, other.name));
}

}  // namespace

Task as_good_as(const FrontPoint& point, std::size_t part, std::size_t sought) {
  Task task;
  task.part = part;
  task.sought = sought;
  task.bounds = point.costs;
  task.bounds[sought] = kInfinity;
  return task;
}

std::vector<std::vector<double>> costs_of(const std::vector<FrontPoint>& points) {
  std::vector<std::vector<double>> result;
  for (const FrontPoint& point : points) result.push_back(point.costs);
  return result;
}

FrontPoint looked_at(const Problem& multi, std::size_t part, Design x) {
  const Problem problem = multi.alone(0);
  const std::vector<LimitReport> limits = limit_reports(problem, scales(problem, x), x, true);
  FrontPoint point = point_of(multi, part, x);
  point.limits = standings(limits, limits.size());
  point.solver = "none";
  const bool met = std::all_of(limits.begin(), limits.end(), [](const auto& l) { return l.met; });
  const bool numbers = std::all_of(point.costs.begin(), point.costs.end(),
                                   [](double c) { return std::isfinite(c); });
  point.verdict = met && numbers ? Verdict::Feasible : Verdict::Failed;
  point.reason = met ? "the design was evaluated, not searched for" : "it violates a limit";
  return point;
}

namespace {
constexpr std::string_view kKinds[] = {"bounded", "toward", "scout", "sample"};
}

bool looks_at_many(std::string_view text) {
  return text.starts_with(kKinds[static_cast<int>(Task::Kind::Scout)]) ||
         text.starts_with(kKinds[static_cast<int>(Task::Kind::Sample)]);
}

std::string Task::text() const {
  const auto numbers = [](const std::vector<double>& values) {
    std::string text;
    for (const double v : values) text += fmt::format(" {:a}", v);
    return text;
  };
  std::string text = fmt::format("{} part {} sought {} bounds{} origin{} direction{} seed {}",
                                 kKinds[static_cast<int>(kind)], part, sought, numbers(bounds),
                                 numbers(origin), numbers(direction), seed);
  if (kind == Kind::Scout) text += fmt::format(" population {} of {}", population, generations);
  if (kind == Kind::Sample) text += fmt::format(" population {}", population);
  for (const auto& start : starts) text += " start" + numbers(start);
  return text;
}

Outcome carry_out(const Task& task, const ProblemSpace& space, const OptimiseOptions& options) {
  const Problem multi = space.problem(space.options(task.part));
  if (task.part > 0) check_same_objectives(space.problem(space.options(0)), multi);
  if (task.kind == Task::Kind::Scout) return scout(task, multi);
  if (task.kind == Task::Kind::Sample) return sample(task, multi);
  OptimiseOptions own = options;
  own.seed = task.seed;
  return search(task, multi, own);
}

Outcome safely(const std::function<Outcome()>& work) {
  Outcome failed;
  try {
    return plain(work());
  } catch (const std::exception& error) {
    failed.failure = error.what();
  } catch (...) {
    failed.failure = "the model raised an error that says nothing of its cause";
  }
  return failed;
}

Outcome carry_out_safely(const Task& task, const ProblemSpace& space,
                         const OptimiseOptions& options) {
  return safely([&] { return carry_out(task, space, options); });
}

Outcomes DirectExecutor::run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) {
  const auto stopped = [&] { return options_.stop != nullptr && *options_.stop; };
  Outcomes outcomes(tasks.size());
  for (std::size_t i = 0; i < tasks.size() && !stopped(); ++i) {
    Outcome outcome = carry_out_safely(tasks[i], space_, options_);
    if (stopped()) break;  // cut short: not what the task gives
    if (on_outcome) on_outcome(tasks[i], outcome);
    outcomes[i] = std::move(outcome);
  }
  return outcomes;
}

}  // namespace camlaw::optim
