// SPDX-License-Identifier: MIT
#include "optim/pareto/pareto.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "optim/cycle/scales.h"
#include "optim/pareto/costs.h"
#include "optim/pareto/scouting.h"

namespace camlaw::optim {
namespace {

constexpr std::size_t kAtOnce = 16;  ///< so many tasks beside the sweep make a round

/// Looks from elsewhere for the ends that were not found.
void find_ends_again(Sweep& sweep) {
  std::vector<Task> tasks;
  for (const auto& part : sweep.parts) {
    for (Task& task : part->repeated_tasks()) tasks.push_back(std::move(task));
  }
  const std::vector<Outcome> outcomes = sweep.carry_out(tasks);
  if (sweep.front.stopped) return;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    sweep.parts[tasks[i].part]->take_repeated(tasks[i], outcomes[i]);
  }
  for (const auto& part : sweep.parts)
    sweep.front.without_end += !part->is_empty() && !part->has_ends();
}

/// Looks for the least of each objective, in each part.
void find_ends(Sweep& sweep, const Scouted& scouted) {
  const std::size_t objectives = sweep.front.objectives.size();
  std::vector<Task> tasks;
  for (const auto& part : sweep.parts) {
    for (Task& task : part->first_tasks(starts_of(scouted[part->part()])))
      tasks.push_back(std::move(task));
  }
  const std::vector<Outcome> outcomes = sweep.carry_out(tasks);
  if (sweep.front.stopped) return;
  for (std::size_t p = 0; p < sweep.parts.size(); ++p) {
    const auto first = outcomes.begin() + static_cast<std::ptrdiff_t>(p * objectives);
    sweep.parts[p]->take_first({first, first + static_cast<std::ptrdiff_t>(objectives)});
    sweep.front.empty_parts += sweep.parts[p]->is_empty();
  }
  find_ends_again(sweep);
}

/// How large an objective is where it is best, its value or a typical change; 0 where that is not
/// known.
double size_of(const ProblemSpace& space, std::size_t objective, const FrontPoint* best) {
  if (best == nullptr) return 0;
  try {
    const Problem problem = space.problem(space.options(best->part)).alone(objective);
    const double value = std::abs(objective_value(problem.objective(), best->x));
    const double size = std::max(value, scales(problem, best->x).objective_typical);
    return std::isfinite(size) ? size : 0;
  } catch (const std::exception&) {
    return 0;  // of a model that throws nearby: all differences count
  }
}

/// Takes tolerances as stated, else shares of the sizes where each objective is best
/// (docs/optimisation.md, "Scales of costs"): the best design is looked up in `points(objective)`.
template <class Points>
void measure_objectives(Front& front, const ProblemSpace& space, Points points) {
  front.tolerances.clear();
  front.sizes.clear();
  const Problem first = space.problem(space.options(0));
  for (std::size_t i = 0; i < first.objectives.size(); ++i) {
    const auto& stated = first.objectives[i].tolerance;
    constexpr double kShare = 1e-7;  // as much as an optimum is known to
    const double size = size_of(space, i, cheapest(points(i), i));
    front.tolerances.push_back(stated ? *stated : kShare * size);
    front.sizes.push_back(size);
  }
}

/// Combinations whose ideal point something dominates are left alone.
void set_up(Sweep& sweep) {
  while (!sweep.front.stopped) {
    const FrontSoFar front = sweep.so_far();
    std::vector<Task> tasks;
    for (const auto& part : sweep.parts) {
      if (part->is_empty() || front.covers(part->least())) continue;
      for (Task& task : part->next_tasks()) tasks.push_back(std::move(task));
    }
    if (tasks.empty()) return;
    sweep.carry_on(std::move(tasks));
  }
}

/// Searches in the largest places that are open, until the front has as many points as wanted.
void refine(Sweep& sweep) {
  // A sweep takes a few per point; one that comes upon nothing new has to end.
  constexpr std::size_t kTasksPerPoint = 20;
  const std::size_t limit =
      sweep.front.tasks + kTasksPerPoint * sweep.options.points + 64 * sweep.parts.size();
  while (sweep.front.tasks < limit && !sweep.front.stopped) {
    std::vector<Task> tasks = next_round(sweep.parts, sweep.so_far(), sweep.options.points);
    if (tasks.empty()) return;
    sweep.carry_on(std::move(tasks));
  }
}

/// Searches for better designs from those of the scout.
void polish(Sweep& sweep, const Scouted& scouted) {
  const std::vector<Task> tasks = polishing_tasks(scouted, sweep);
  for (std::size_t i = 0; i < tasks.size() && !sweep.front.stopped; i += kAtOnce) {
    const auto from = tasks.begin() + static_cast<std::ptrdiff_t>(i);
    const auto to = from + static_cast<std::ptrdiff_t>(std::min(kAtOnce, tasks.size() - i));
    sweep.carry_on({from, to});
  }
}

/// Designs of the scout that show that a search was stuck are searched from, and what that leads
/// to is refined as well.
void look_again(Sweep& sweep, const Scouted& scouted) {
  // Each round is a sweep of its own and leaves fewer designs to the next.
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds && !sweep.front.stopped; ++round) {
    std::vector<Task> tasks = tasks_where_stuck(scouted, sweep, kAtOnce);
    if (tasks.empty()) return;
    sweep.carry_on(std::move(tasks));
    refine(sweep);
  }
}

/// Carries out all stages in turn, until the study is stopped.
void search(Sweep& sweep) {
  const Scouted scouted = scout_parts(sweep);
  if (sweep.front.stopped) return;
  find_ends(sweep, scouted);
  measure_objectives(sweep.front, sweep.space, [&](std::size_t objective) {
    std::vector<FrontPoint> ends;
    for (const auto& part : sweep.parts) {
      if (const FrontPoint* end = part->end(objective)) ends.push_back(*end);
    }
    return ends;
  });
  for (const auto& part : sweep.parts) part->know(sweep.front.tolerances, sweep.front.sizes);
  set_up(sweep);
  if (sweep.options.method == ParetoMethod::Nsga2) return polish(sweep, scouted);
  refine(sweep);
  look_again(sweep, scouted);
}

/// Whether a mixture of two designs costs no more than the mixture of their costs.
bool costs_are_convex(const Problem& multi) {
  return std::all_of(multi.objectives.begin(), multi.objectives.end(), [](const Objective& o) {
    const Shape shape = o.response.shape();
    if (o.part == Part::Magnitude) return shape == Shape::Linear;
    return o.sense == Sense::Minimize ? is_convex(shape) : is_concave(shape);
  });
}

/// Tightens what is known between the points, for a convex problem.
void settle_convex(Front& front, const Problem& multi) {
  if (!costs_are_convex(multi) || !searches_are_convex(multi)) return;
  const std::vector<Costs> all = costs_of(front.points);
  front.hypervolume_of_mixtures = hypervolume_of_mixtures(all, front.reference);
  std::vector<std::vector<double>> weights;
  for (const FrontPoint& point : front.points) {
    if (point.verdict != Verdict::Certified || point.weights.empty()) return;
    if (std::ranges::any_of(point.weights, [](double w) { return std::isnan(w); })) return;
    weights.push_back(point.weights);
  }
  front.hypervolume_at_most =
      std::min(*front.hypervolume_at_most, hypervolume_within(all, weights, front.reference));
}

/// The best of each objective alone, where the point beside it has taken its place on the front,
/// and whether that is certified.
void settle_ends(Sweep& sweep) {
  Front& front = sweep.front;
  const auto is_finite = [](double c) { return std::isfinite(c); };
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    bool is_certified = true;
    for (const auto& part : sweep.parts) {
      if (part->is_empty()) continue;
      const FrontPoint* end = part->end(i);
      const bool is_sound = end != nullptr && end->verdict == Verdict::Certified;
      is_certified = is_certified && is_sound;
      if (!is_sound || !std::ranges::all_of(end->costs, is_finite)) continue;
      front.ideal[i] = std::min(front.ideal[i], end->costs[i]);
    }
    front.ideal_certified.push_back(is_certified && !front.stopped);
  }
}

/// Gives the sweep's front its points, and measures it.
void settle(Sweep& sweep, FrontSoFar found) {
  Front& front = sweep.front;
  front.complete = !front.stopped;
  const bool is_pair = front.objectives.size() == 2;
  if (sweep.options.method != ParetoMethod::Nsga2 && !(is_pair && front.stopped)) {
    if (!is_pair) found = spread(std::move(found), sweep.options.points);
    front.largest_gap = evenness(sweep.parts, found).ratio();
    front.complete = front.complete && *front.largest_gap <= kLargestGap;
  }
  front.points = std::move(found.points);
  const std::vector<Costs> all = costs_of(front.points);
  if (all.empty()) return;
  front.ideal = ideal(all);
  settle_ends(sweep);
  front.nadir = nadir(all);
  front.reference = sweep.reference(all);
  front.hypervolume = hypervolume(all, front.reference);
}

/// Works out what no front exceeds, where searches have told enough.
void settle_bounds(Sweep& sweep) {
  Front& front = sweep.front;
  std::vector<Costs> all = costs_of(front.points);
  if (all.empty()) return;
  // A search that failed tells nothing of what it left out.
  const bool bounded = front.objectives.size() == 2 && front.failures.empty();
  if (!bounded || sweep.options.method == ParetoMethod::Nsga2) return;
  for (const auto& part : sweep.parts) {
    for (Costs& corner : part->corners()) all.push_back(std::move(corner));
  }
  front.hypervolume_at_most = hypervolume(all, front.reference);
  if (front.parts == 1) settle_convex(front, sweep.space.problem(sweep.space.options(0)));
}

}  // namespace

bool Front::counts(const FrontPoint& point, std::size_t objective) const {
  // Of all weights: an interior-point method leaves less to idle limits.
  constexpr double kNothing = 1e-6;
  if (point.weights.empty()) return false;
  const auto unit = [&](std::size_t i) {
    const bool is_scaled = point.weights.size() == 2 && i < sizes.size() && sizes[i] > 0;
    if (!(nadir[i] > ideal[i])) return 1.0;
    if (!is_scaled) return nadir[i] - ideal[i];
    return CostScale(ideal[i], nadir[i], 0, sizes[i]).slope(point.costs[i]);
  };
  double sum = 0;
  for (std::size_t i = 0; i < point.weights.size(); ++i) sum += point.weights[i] * unit(i);
  const double its = point.weights[objective] * unit(objective);
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
  Sweep sweep(space, options, executor);
  search(sweep);
  settle(sweep, sweep.so_far());
  settle_bounds(sweep);
  std::string& remark = sweep.front.remark;
  const std::string of_tasks = executor.remark();
  remark = of_tasks + (of_tasks.empty() || remark.empty() ? "" : "; ") + remark;
  return std::move(sweep.front);
}

Front front_of_designs(const ProblemSpace& space, const ParetoOptions& options,
                       const std::vector<FrontPoint>& designs) {
  DirectExecutor none(space, options.solve);
  Sweep sweep(space, options, none);
  sweep.front.stopped = true;
  sweep.front.each_is_global = false;
  std::vector<FrontPoint> numbers;
  std::copy_if(designs.begin(), designs.end(), std::back_inserter(numbers), [](const auto& point) {
    return std::all_of(point.costs.begin(), point.costs.end(),
                       [](double c) { return std::isfinite(c); });
  });
  measure_objectives(
      sweep.front, space, [&](std::size_t) -> const auto& { return numbers; });
  settle(sweep, front_of(numbers, sweep.front.tolerances, sweep.front.sizes));
  return std::move(sweep.front);
}

Front pareto(const ProblemSpace& space, const ParetoOptions& options) {
  DirectExecutor executor(space, options.solve);
  return pareto(space, options, executor);
}

Front pareto(const Problem& problem, const ParetoOptions& options) {
  return pareto(ProblemSpace::of(problem), options);
}

}  // namespace camlaw::optim
