// SPDX-License-Identifier: MIT
#include "optim/pareto/pareto.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "optim/cycle/sizes.h"
#include "optim/pareto/costs.h"
#include "optim/pareto/nsga2.h"
#include "optim/pareto/round.h"

namespace camlaw::optim {
namespace {

/// Whether every search of the sweep has one optimum, whatever its bounds.
bool is_convex(const Problem& multi) {
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

/// Whether a mixture of two designs costs no more than the mixture of their costs.
bool costs_are_convex(const Problem& multi) {
  return std::all_of(multi.objectives.begin(), multi.objectives.end(), [](const Objective& o) {
    const Shape shape = o.response.shape();
    if (o.part == Part::Magnitude) return shape == Shape::Linear;
    return o.sense == Sense::Minimize ? camlaw::optim::is_convex(shape) : is_concave(shape);
  });
}

std::size_t varying(const Problem& multi) {
  return static_cast<std::size_t>(
      std::count_if(multi.variables.begin(), multi.variables.end(),
                    [](const Variable& v) { return v.lower < v.upper; }));
}

class Study {
 public:
  Study(const ProblemSpace& space, const ParetoOptions& options, Executor& executor)
      : space_(space), options_(options), executor_(executor) {
    front_.parts = space.parts();
    progress_.wanted = options.points;
    const Problem first = space.problem(space.options(0));
    first.check();
    if (first.objectives.size() < 2) {
      throw std::invalid_argument("a front needs two objectives or more; there is 1");
    }
    if (options.reference && options.reference->size() != first.objectives.size()) {
      throw std::invalid_argument("reference: one number for each objective is wanted");
    }
    if (options.method == ParetoMethod::Nsga2) require_nsga2();
    for (const Objective& o : first.objectives) {
      front_.objectives.push_back({o.response.name, o.response.unit, o.sense, o.part});
    }
    for (std::size_t part = 0; part < front_.parts; ++part) {
      parts_.push_back(objectives() == 2 ? box_front(part) : direction_front(part, objectives()));
    }
  }

  Front run() {
    const bool done = scout() && begin() && refine() && look_again();
    front_.stopped = !done;
    settle(so_far());
    settle_bounds();
    return std::move(front_);
  }

  /// Of designs that were found before, without a search.
  Front of(const std::vector<FrontPoint>& designs) {
    front_.stopped = true;
    front_.each_is_global = false;
    std::vector<FrontPoint> numbers;
    for (const FrontPoint& point : designs) {
      const bool finite = std::all_of(point.costs.begin(), point.costs.end(),
                                      [](double c) { return std::isfinite(c); });
      if (finite) numbers.push_back(point);
    }
    settle_tolerances([&](std::size_t objective) {
      const auto best = std::min_element(numbers.begin(), numbers.end(),
                                         [&](const FrontPoint& a, const FrontPoint& b) {
                                           return a.costs[objective] < b.costs[objective];
                                         });
      return best == numbers.end() ? nullptr : &*best;
    });
    settle(front_of(numbers, front_.tolerances));
    return std::move(front_);
  }

 private:
  std::size_t objectives() const { return front_.objectives.size(); }

  /// Carries tasks out, all with the study's seed; whether all were.
  bool carry_out(std::vector<Task>& tasks, std::vector<Outcome>& outcomes) {
    for (Task& task : tasks) task.seed = options_.seed;
    outcomes = executor_.run(tasks, [this](const auto&, const auto&) { count_task(); });
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      front_.evaluations += outcomes[i].evaluations;
      const bool is_search = tasks[i].kind != Task::Kind::Scout;
      front_.each_is_global = front_.each_is_global && (outcomes[i].is_global || !is_search);
      if (outcomes[i].failure.empty()) continue;
      front_.failures.push_back({front_.tasks + i, tasks[i].part, outcomes[i].failure});
    }
    front_.tasks += outcomes.size();
    return outcomes.size() == tasks.size();
  }

  /// Combinations that NSGA-II looks at first.
  bool scout() {
    std::vector<Task> tasks;
    for (const auto& part : parts_) {
      const Problem multi = space_.problem(space_.options(part->part()));
      const bool wanted = options_.method == ParetoMethod::Nsga2 ||
                          (options_.method == ParetoMethod::Automatic && !is_convex(multi) &&
                           (options_.scouts ? *options_.scouts : has_nsga2()));
      if (wanted && varying(multi) > 0) tasks.push_back(scout_task(part->part()));
    }
    scouted_.resize(parts_.size());
    std::vector<Outcome> outcomes;
    const bool done = carry_out(tasks, outcomes);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      scouted_[tasks[i].part] = outcomes[i].points;
      parts_[tasks[i].part]->see(outcomes[i].points);
    }
    report();
    return done;
  }

  Task scout_task(std::size_t part) const {
    constexpr std::size_t kFewest = 40, kMost = 100, kGenerations = 50, kAlone = 250;
    const bool alone = options_.method == ParetoMethod::Nsga2;
    const std::size_t usual =
        alone ? std::max(options_.points, kMost) : std::clamp(options_.points, kFewest, kMost);
    Task task;
    task.kind = Task::Kind::Scout;
    task.part = part;
    task.population = options_.population > 0 ? options_.population : usual;
    task.generations =
        options_.generations > 0 ? options_.generations : (alone ? kAlone : kGenerations);
    return task;
  }

  /// Designs that the scout found, to begin with: the best for each objective.
  std::vector<std::vector<double>> starts_of(std::size_t part) const {
    std::vector<std::vector<double>> starts;
    const auto& found = scouted_[part];
    for (std::size_t i = 0; i < objectives() && !found.empty(); ++i) {
      starts.push_back(std::min_element(found.begin(), found.end(),
                                        [i](const FrontPoint& a, const FrontPoint& b) {
                                          return a.costs[i] < b.costs[i];
                                        })
                           ->x);
    }
    return starts;
  }

  bool begin() {
    const bool done = look_for_ends();
    settle_tolerances([this](std::size_t objective) { return best_end(objective); });
    for (const auto& part : parts_) part->know(front_.tolerances);
    return done && set_up();
  }

  /// As stated, else the defaults where each objective is best (docs/optimisation.md, (Z3)):
  /// at `best(objective)`, nullptr where no design is known.
  template <class Best>
  void settle_tolerances(Best best) {
    const Problem first = space_.problem(space_.options(0));
    for (std::size_t i = 0; i < objectives(); ++i) {
      const auto& stated = first.objectives[i].tolerance;
      front_.tolerances.push_back(stated ? *stated : default_tolerance(i, best(i)));
    }
  }

  const FrontPoint* best_end(std::size_t objective) const {
    const FrontPoint* best = nullptr;
    for (const auto& part : parts_) {
      const auto* end = part->end(objective);
      if (end != nullptr && (best == nullptr || end->costs[objective] < best->costs[objective])) {
        best = end;
      }
    }
    return best;
  }

  double default_tolerance(std::size_t objective, const FrontPoint* best) const {
    if (best == nullptr) return 0;
    try {
      const Problem problem = space_.problem(space_.options(best->part)).alone(objective);
      const double tolerance = sizes(problem, best->x).objective_tolerance;
      return std::isfinite(tolerance) ? tolerance : 0;
    } catch (const std::exception&) {
      return 0;  // of a model that throws nearby: all differences count
    }
  }

  bool look_for_ends() {
    std::vector<Task> tasks;
    for (const auto& part : parts_) {
      for (Task& task : part->first_tasks(starts_of(part->part())))
        tasks.push_back(std::move(task));
    }
    std::vector<Outcome> outcomes;
    if (!carry_out(tasks, outcomes)) return false;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const auto first = outcomes.begin() + static_cast<std::ptrdiff_t>(p * objectives());
      parts_[p]->take_first({first, first + static_cast<std::ptrdiff_t>(objectives())});
      front_.empty_parts += parts_[p]->is_empty();
    }
    return look_for_ends_again();
  }

  bool look_for_ends_again() {
    std::vector<Task> tasks;
    for (const auto& part : parts_) {
      for (Task& task : part->repeated_tasks()) tasks.push_back(std::move(task));
    }
    std::vector<Outcome> outcomes;
    if (!carry_out(tasks, outcomes)) return false;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      parts_[tasks[i].part]->take_repeated(tasks[i], outcomes[i]);
    }
    for (const auto& part : parts_) front_.without_end += !part->is_empty() && !part->has_ends();
    return true;
  }

  /// Combinations whose ideal point something dominates are left alone.
  bool set_up() {
    for (;;) {
      const FrontSoFar front = so_far();
      std::vector<Task> tasks;
      for (const auto& part : parts_) {
        if (part->is_empty() || front.covers(part->least())) continue;
        for (Task& task : part->next_tasks()) tasks.push_back(std::move(task));
      }
      if (tasks.empty()) return true;
      if (!carry_out_and_give(std::move(tasks))) return false;
    }
  }

  bool carry_out_and_give(std::vector<Task> tasks) {
    std::vector<Outcome> outcomes;
    const bool done = carry_out(tasks, outcomes);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      parts_[tasks[i].part]->take(tasks[i], outcomes[i]);
    }
    report();
    return done;
  }

  /// The largest places that are open, until the front has as many points as wanted.
  bool refine() {
    if (options_.method == ParetoMethod::Nsga2) return polish();
    const std::size_t limit = front_.tasks + kTasksPerPoint * options_.points + 64 * parts_.size();
    while (front_.tasks < limit) {
      std::vector<Task> tasks = next_round(parts_, so_far(), options_.points);
      if (tasks.empty()) return true;
      if (!carry_out_and_give(std::move(tasks))) return false;
    }
    return true;
  }

  /// No more than `count` of a front's points, its ends among them.
  static std::vector<FrontPoint> evenly(std::vector<FrontPoint> front, std::size_t count) {
    if (front.size() <= count) return front;
    std::vector<FrontPoint> some;
    for (std::size_t i = 0; i < count; ++i) {
      some.push_back(front[i * (front.size() - 1) / (count - 1)]);
    }
    return some;
  }

  /// Designs of the scout, as many as points are wanted, as the starts of searches for better ones.
  bool polish() {
    const FrontSoFar front = so_far();
    std::vector<FrontPoint> all;
    for (const auto& found : scouted_) all.insert(all.end(), found.begin(), found.end());
    std::vector<Task> tasks;
    for (const FrontPoint& point : evenly(front_of(all).points, options_.points)) {
      if (parts_[point.part]->is_empty() || front.covers(point.costs)) continue;
      tasks.push_back(as_good_as(point, point.part, objectives() - 1));
      tasks.back().starts = {point.x};
    }
    for (std::size_t i = 0; i < tasks.size(); i += kRound) {
      const auto from = tasks.begin() + static_cast<std::ptrdiff_t>(i);
      const auto to = from + static_cast<std::ptrdiff_t>(std::min(kRound, tasks.size() - i));
      if (!carry_out_and_give({from, to})) return false;
    }
    return true;
  }

  /// Designs of the scout that show that a search was stuck are searched from, and what that leads
  /// to is refined as well.
  bool look_again() {
    constexpr int kRounds = 5;
    if (options_.method == ParetoMethod::Nsga2) return true;
    for (int round = 0; round < kRounds; ++round) {
      const FrontSoFar front = so_far();
      std::vector<Task> tasks;
      for (const auto& found : scouted_) {
        for (const FrontPoint& point : found) {
          if (parts_[point.part]->is_empty() || tasks.size() == kRound) continue;
          auto task = parts_[point.part]->task_for(point, front);
          if (!task) continue;
          tasks.push_back(std::move(*task));
        }
      }
      if (tasks.empty()) return true;
      if (!carry_out_and_give(std::move(tasks)) || !refine()) return false;
    }
    return true;
  }

  FrontSoFar so_far() const {
    std::vector<FrontPoint> points;
    for (const auto& part : parts_) {
      points.insert(points.end(), part->points().begin(), part->points().end());
    }
    return front_of(points, front_.tolerances);
  }

  Costs reference(const std::vector<Costs>& all) const {
    return options_.reference ? *options_.reference : default_reference(all, front_.tolerances);
  }

  /// Works out how far the front is, and tells.
  void report() {
    if (!options_.progress) return;
    const std::vector<Costs> all = costs_of(so_far().points);
    progress_.points = all.size();
    progress_.hypervolume = all.empty() ? 0 : hypervolume(all, reference(all));
    options_.progress(progress_);
  }

  void count_task() {
    ++progress_.tasks;
    if (options_.progress) options_.progress(progress_);
  }

  void settle(FrontSoFar found) {
    front_.complete = !front_.stopped;
    if (objectives() > 2 && options_.method != ParetoMethod::Nsga2) {
      found = spread(std::move(found), options_.points);
      front_.largest_gap = evenness(parts_, found).ratio();
      front_.complete = front_.complete && *front_.largest_gap <= kLargestGap;
    }
    front_.points = std::move(found.points);
    const std::vector<Costs> all = costs_of(front_.points);
    if (all.empty()) return;
    front_.ideal = ideal(all);
    front_.nadir = nadir(all);
    front_.reference = reference(all);
    front_.hypervolume = hypervolume(all, front_.reference);
  }

  /// What no front exceeds, where searches have told enough.
  void settle_bounds() {
    std::vector<Costs> all = costs_of(front_.points);
    if (all.empty()) return;
    // A search that failed tells nothing of what it left out.
    const bool bounded = objectives() == 2 && front_.failures.empty();
    if (!bounded || options_.method == ParetoMethod::Nsga2) return;
    for (const auto& part : parts_) {
      for (Costs& corner : part->corners()) all.push_back(std::move(corner));
    }
    front_.hypervolume_at_most = hypervolume(all, front_.reference);
    if (front_.parts == 1) settle_convex();
  }

  /// Of a convex problem more is known of what lies between the points.
  void settle_convex() {
    const Problem multi = space_.problem(space_.options(0));
    if (!costs_are_convex(multi) || !is_convex(multi)) return;
    const std::vector<Costs> all = costs_of(front_.points);
    front_.hypervolume_of_mixtures = hypervolume_of_mixtures(all, front_.reference);
    std::vector<std::vector<double>> weights;
    for (const FrontPoint& point : front_.points) {
      if (point.verdict != Verdict::Certified || point.weights.empty()) return;
      weights.push_back(point.weights);
    }
    front_.hypervolume_at_most =
        std::min(*front_.hypervolume_at_most, hypervolume_within(all, weights, front_.reference));
  }

  static constexpr std::size_t kTasksPerPoint = 20;
  static constexpr std::size_t kRound = 16;  ///< tasks of a round beside the sweep

  const ProblemSpace& space_;
  const ParetoOptions& options_;
  Executor& executor_;
  Front front_;
  StudyProgress progress_;
  std::vector<std::unique_ptr<PartFront>> parts_;
  std::vector<std::vector<FrontPoint>> scouted_;  ///< of each part
};

}  // namespace

bool Front::counts(const FrontPoint& point, std::size_t objective) const {
  constexpr double kNothing = 1e-6;
  if (point.weights.empty()) return false;
  double sum = 0, its = 0;
  for (std::size_t i = 0; i < point.weights.size(); ++i) {
    const double range = nadir[i] > ideal[i] ? nadir[i] - ideal[i] : 1;
    sum += point.weights[i] * range;
    if (i == objective) its = point.weights[i] * range;
  }
  return its > kNothing * sum;
}

double Front::slope(const FrontPoint& point, std::size_t of, std::size_t per) const {
  if (!counts(point, of) || !counts(point, per)) return std::nan("");
  const bool same = objectives[of].sense == objectives[per].sense;
  return (same ? -1 : 1) * point.weights[per] / point.weights[of];
}

double Front::price(const FrontPoint& point, const Standing& limit) const {
  return counts(point, 0) ? limit.price / point.weights[0] : std::nan("");
}

std::size_t Front::certified() const {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(),
                    [](const FrontPoint& p) { return p.verdict == Verdict::Certified; }));
}

Front pareto(const ProblemSpace& space, const ParetoOptions& options, Executor& executor) {
  if (options.points < 2) throw std::invalid_argument("points: a front has at least two");
  check_solvers(options.solve);
  Front front = Study(space, options, executor).run();
  front.remark = executor.remark();
  return front;
}

Front front_of_designs(const ProblemSpace& space, const ParetoOptions& options,
                       const std::vector<FrontPoint>& designs) {
  DirectExecutor none(space, options.solve);
  return Study(space, options, none).of(designs);
}

Front pareto(const ProblemSpace& space, const ParetoOptions& options) {
  DirectExecutor executor(space, options.solve);
  return pareto(space, options, executor);
}

Front pareto(const Problem& problem, const ParetoOptions& options) {
  return pareto(ProblemSpace::of(problem), options);
}

}  // namespace camlaw::optim
