// SPDX-License-Identifier: MIT
#include "optim/pareto/sweep.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "optim/pareto/nsga2.h"

namespace camlaw::optim {

Sweep::Sweep(const ProblemSpace& its_space, const ParetoOptions& its_options, Executor& executor)
    : space(its_space), options(its_options), executor_(executor) {
  progress_.wanted = options.points;
  front.parts = space.parts();
  const Problem first = space.problem(space.options(0));
  first.check();
  const std::size_t objectives = first.objectives.size();
  if (objectives < 2) {
    throw std::invalid_argument("a front needs at least two objectives; this problem has one");
  }
  if (options.reference && options.reference->size() != objectives) {
    throw std::invalid_argument("reference: give one number for each objective");
  }
  if (options.method == ParetoMethod::Nsga2) require_nsga2();
  for (const Objective& o : first.objectives) {
    front.objectives.push_back({o.response.name, o.response.unit, o.sense, o.part});
  }
  for (std::size_t part = 0; part < front.parts; ++part) {
    parts.push_back(objectives == 2 ? box_front(part) : direction_front(part, objectives));
  }
}

std::vector<Outcome> Sweep::carry_out(std::vector<Task>& tasks) {
  for (Task& task : tasks) task.seed = options.seed;
  Outcomes all = executor_.run(tasks, [this](const auto&, const auto&) {
    ++progress_.tasks;
    if (options.progress) options.progress(progress_);
  });
  std::vector<Task> done;
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (!all[i]) continue;
    done.push_back(std::move(tasks[i]));
    outcomes.push_back(std::move(*all[i]));
  }
  front.stopped = front.stopped || done.size() < tasks.size();
  tasks = std::move(done);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    front.evaluations += outcomes[i].evaluations;
    const bool is_search = !tasks[i].looks_at_many();
    front.each_is_global = front.each_is_global && (outcomes[i].is_global || !is_search);
    if (outcomes[i].failure.empty()) continue;
    front.failures.push_back({front.tasks + i, tasks[i].part, outcomes[i].failure});
  }
  front.tasks += outcomes.size();
  return outcomes;
}

void Sweep::carry_on(std::vector<Task> tasks) {
  const std::vector<Outcome> outcomes = carry_out(tasks);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    parts[tasks[i].part]->take(tasks[i], outcomes[i]);
  }
  report();
}

FrontSoFar Sweep::so_far() const {
  std::vector<FrontPoint> points;
  for (const auto& part : parts) {
    points.insert(points.end(), part->points().begin(), part->points().end());
  }
  return front_of(points, front.tolerances, front.sizes);
}

Costs Sweep::reference(const std::vector<Costs>& costs) const {
  return options.reference ? *options.reference : default_reference(costs, front.tolerances);
}

void Sweep::report() {
  if (!options.progress) return;
  const std::vector<Costs> all = costs_of(so_far().points);
  progress_.points = all.size();
  progress_.hypervolume = all.empty() ? 0 : hypervolume(all, reference(all));
  options.progress(progress_);
}

const FrontPoint* cheapest(const std::vector<FrontPoint>& points, std::size_t objective) {
  const auto best =
      std::min_element(points.begin(), points.end(), [&](const FrontPoint& a, const FrontPoint& b) {
        return a.costs[objective] < b.costs[objective];
      });
  return best == points.end() ? nullptr : &*best;
}

}  // namespace camlaw::optim
