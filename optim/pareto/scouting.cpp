// SPDX-License-Identifier: MIT
#include "optim/pareto/scouting.h"

#include <algorithm>
#include <utility>

#include "optim/pareto/costs.h"
#include "optim/pareto/nsga2.h"

namespace camlaw::optim {
namespace {

bool is_there(const ParetoOptions& options) {
  if (options.method == ParetoMethod::Nsga2) return true;
  return options.scouts ? *options.scouts : has_nsga2();
}

/// Whether NSGA-II is to look at a problem, be it there or not.
bool may_help(const Problem& multi, const ParetoOptions& options) {
  const bool varies = std::any_of(multi.variables.begin(), multi.variables.end(),
                                  [](const Variable& v) { return v.lower < v.upper; });
  if (options.method != ParetoMethod::Automatic)
    return varies && options.method == ParetoMethod::Nsga2;
  return varies && !searches_are_convex(multi);
}

Task scout_task(std::size_t part, const ParetoOptions& options) {
  // Alone NSGA-II gets the population and the generations of Deb and others (2002); as a scout it
  // has to find the region of each part, which the searches then refine.
  constexpr std::size_t kFewest = 40, kMost = 100, kGenerations = 50, kAlone = 250;
  const bool alone = options.method == ParetoMethod::Nsga2;
  const std::size_t usual =
      alone ? std::max(options.points, kMost) : std::clamp(options.points, kFewest, kMost);
  Task task;
  task.kind = Task::Kind::Scout;
  task.part = part;
  task.population = options.population > 0 ? options.population : usual;
  task.generations =
      options.generations > 0 ? options.generations : (alone ? kAlone : kGenerations);
  return task;
}

/// In place of a scout.
Task sample_task(std::size_t part) {
  // Several in each region that takes a hundredth of the box; a scout evaluates twice to five
  // times as many.
  constexpr std::size_t kSampled = 1024;
  Task task;
  task.kind = Task::Kind::Sample;
  task.part = part;
  task.population = kSampled;
  return task;
}

/// Keeps no more than `count` of a front's points, its ends among them.
std::vector<FrontPoint> evenly(std::vector<FrontPoint> front, std::size_t count) {
  if (front.size() <= count) return front;
  std::vector<FrontPoint> some;
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(front[i * (front.size() - 1) / (count - 1)]);
  }
  return some;
}

}  // namespace

bool searches_are_convex(const Problem& multi) {
  const bool steps = std::any_of(multi.variables.begin(), multi.variables.end(),
                                 [](const Variable& v) { return v.integer && v.lower < v.upper; });
  if (steps) return false;
  for (std::size_t sought = 0; sought < multi.objectives.size(); ++sought) {
    Problem problem = multi.alone(sought);
    for (std::size_t i = 0; i < multi.objectives.size(); ++i) {
      if (i != sought) problem.constraints.push_back(at_most(multi.objectives[i], 1));
    }
    if (!why_convex(problem)) return false;
  }
  return true;
}

Scouted scout_parts(Sweep& sweep) {
  std::vector<Task> tasks;
  const bool by_scouts = is_there(sweep.options);
  for (std::size_t part = 0; part < sweep.parts.size(); ++part) {
    if (may_help(sweep.space.problem(sweep.space.options(part)), sweep.options))
      tasks.push_back(by_scouts ? scout_task(part, sweep.options) : sample_task(part));
  }
  if (!tasks.empty() && !by_scouts) {
    sweep.front.remark =
        "NSGA-II, which normally scouts such a problem, is not installed (plug-in "
        "camlaw-nsga2.so); the best of an even sample were used instead, so part of the front may "
        "be missing";
  }
  Scouted scouted(sweep.parts.size());
  const std::vector<Outcome> outcomes = sweep.carry_out(tasks);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    scouted[tasks[i].part] = outcomes[i].points;
    sweep.parts[tasks[i].part]->see(outcomes[i].points);
  }
  sweep.report();
  return scouted;
}

std::vector<std::vector<double>> starts_of(const std::vector<FrontPoint>& found) {
  std::vector<std::vector<double>> starts;
  for (std::size_t i = 0; !found.empty() && i < found.front().costs.size(); ++i) {
    starts.push_back(cheapest(found, i)->x);
  }
  return starts;
}

std::vector<Task> polishing_tasks(const Scouted& scouted, const Sweep& sweep) {
  const FrontSoFar front = sweep.so_far();
  std::vector<FrontPoint> all;
  for (const auto& found : scouted) all.insert(all.end(), found.begin(), found.end());
  std::vector<Task> tasks;
  for (const FrontPoint& point : evenly(front_of(all).points, sweep.options.points)) {
    if (sweep.parts[point.part]->is_empty() || front.covers(point.costs)) continue;
    tasks.push_back(as_good_as(point, point.part, point.costs.size() - 1));
    tasks.back().starts = {point.x};
  }
  return tasks;
}

std::vector<Task> tasks_where_stuck(const Scouted& scouted, const Sweep& sweep, std::size_t most) {
  const FrontSoFar front = sweep.so_far();
  std::vector<Task> tasks;
  for (const auto& found : scouted) {
    for (const FrontPoint& point : found) {
      if (sweep.parts[point.part]->is_empty() || tasks.size() == most) continue;
      auto task = sweep.parts[point.part]->task_for(point, front);
      if (task) tasks.push_back(std::move(*task));
    }
  }
  return tasks;
}

}  // namespace camlaw::optim
