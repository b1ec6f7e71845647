// SPDX-License-Identifier: MIT
#include "optim/pareto/scout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "numerics/sampling/sobol_points.h"
#include "optim/cycle/scales.h"
#include "optim/pareto/costs.h"
#include "optim/pareto/dominance.h"
#include "optim/pareto/measures.h"
#include "optim/pareto/nsga2.h"

namespace camlaw::optim {
namespace {

/// What NSGA-II is given: integer variables last, bounds finite.
struct Genome {
  std::vector<std::size_t> variables;  ///< of the problem, in the genes' order
  std::vector<double> lower, upper, fixed;
  std::size_t integer = 0;
};

Genome genome_of(const Problem& multi) {
  Genome genome;
  const Problem problem = multi.alone(0);
  const std::vector<double> scales = variable_scales(problem);
  genome.fixed = problem.start();
  for (const bool integer : {false, true}) {
    for (std::size_t i = 0; i < multi.variables.size(); ++i) {
      const Variable& v = multi.variables[i];
      if (v.integer != integer || v.lower == v.upper) continue;
      // Without bounds it looks about the start.
      constexpr double kFar = 10;
      const double reach = kFar * scales[i];
      genome.variables.push_back(i);
      const double lower = std::isfinite(v.lower) ? v.lower : v.start - reach;
      const double upper = std::isfinite(v.upper) ? v.upper : v.start + reach;
      genome.lower.push_back(integer ? std::ceil(lower) : lower);
      genome.upper.push_back(integer ? std::floor(upper) : upper);
      genome.integer += integer;
    }
  }
  return genome;
}

std::vector<double> design_of(const Genome& genome, const std::vector<double>& genes) {
  std::vector<double> x = genome.fixed;
  for (std::size_t k = 0; k < genes.size(); ++k) x[genome.variables[k]] = genes[k];
  return x;
}

/// The problem without limits that NSGA-II sees.
struct Unlimited {
  const Problem& multi;
  const Problem& problem;
  const Scales& scales;

  /// More than any cost that is worth having: what passes a limit is worse than all that does not.
  static constexpr double kBeyond = 1e100;

  std::vector<double> costs_of(Design x) const {
    std::vector<double> cost(multi.objectives.size(), 4 * kBeyond);
    try {
      measure(x, cost);
    } catch (const std::exception&) {
      // Not a design to be had; searches say what was thrown, where they come upon it.
    }
    return cost;
  }

  void measure(Design x, std::vector<double>& cost) const {
    const double violation = worst_excess(x);
    if (violation > 0) {
      const double graded = std::isfinite(violation) ? violation / (1 + violation) : 2;
      std::fill(cost.begin(), cost.end(), kBeyond * (1 + graded));
      return;
    }
    const std::vector<double> its = costs(multi, x);
    for (std::size_t i = 0; i < its.size(); ++i) {
      if (its[i] < kBeyond) cost[i] = its[i];  // else, or where it is not a number: the worst
    }
  }

  /// Largest violation by size beyond what is tolerated; not above 0 where every limit is met.
  double worst_excess(Design x) const {
    if (multi.constraints.empty()) return 0;
    const double worst = largest_violation(problem, scales, x);
    if (std::isnan(worst)) return kInfinity;
    double tolerated = kInfinity;
    for (const ConstraintScale& c : scales.constraints) {
      tolerated = std::min(tolerated, c.tolerance / c.scale);
    }
    return worst > tolerated ? worst : 0;
  }
};

/// The designs that the genes of a place in the unit cube stand for.
std::vector<double> genes_at(const Genome& genome, std::span<const double> place) {
  std::vector<double> genes(place.size());
  for (std::size_t k = 0; k < genes.size(); ++k) {
    const bool integer = k + genome.integer >= genes.size();
    const double lower = genome.lower[k], upper = genome.upper[k];
    genes[k] = integer ? std::min(upper, lower + std::floor(place[k] * (upper - lower + 1)))
                       : std::lerp(lower, upper, place[k]);
  }
  return genes;
}

/// The costs of the design that genes stand for.
using CostsOfGenes = std::function<std::vector<double>(const std::vector<double>& genes)>;

/// Of the designs that `find` looks at those that meet every limit and that no other one dominates.
Outcome best_of(
    const Task& task, const Problem& multi, const char* by,
    const std::function<std::vector<Evolved>(const Genome&, const CostsOfGenes&)>& find) {
  const Genome genome = genome_of(multi);
  Outcome outcome;
  if (genome.variables.empty()) {
    outcome.points.push_back(looked_at(multi, task.part, genome.fixed));
    outcome.evaluations = 1;
    return outcome;
  }
  const Problem problem = multi.alone(0);
  const Scales its_scales = scales(problem, problem.start());
  const Unlimited unlimited{multi, problem, its_scales};
  const std::vector<Evolved> found = find(genome, [&](const std::vector<double>& genes) {
    ++outcome.evaluations;
    return unlimited.costs_of(design_of(genome, genes));
  });
  std::vector<Costs> all;
  for (const Evolved& one : found) all.push_back(one.costs);
  const std::vector<bool> kept = non_dominated(all);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!kept[i] || !(all[i].front() < Unlimited::kBeyond)) continue;
    FrontPoint point = looked_at(multi, task.part, design_of(genome, found[i].genes));
    point.solver = by;
    if (point.verdict == Verdict::Feasible) outcome.points.push_back(std::move(point));
  }
  return outcome;
}

}  // namespace

Outcome scout(const Task& task, const Problem& multi) {
  return best_of(task, multi, "nsga2", [&](const Genome& genome, const CostsOfGenes& costs) {
    return nsga2({.lower = genome.lower,
                  .upper = genome.upper,
                  .integers = genome.integer,
                  .objectives = multi.objectives.size(),
                  .population = std::max<std::size_t>(8, (task.population + 3) / 4 * 4),
                  .generations = static_cast<unsigned>(task.generations),
                  .seed = static_cast<unsigned>(task.seed),
                  .costs = costs});
  });
}

Outcome sample(const Task& task, const Problem& multi) {
  return best_of(task, multi, "sample", [&](const Genome& genome, const CostsOfGenes& costs) {
    std::vector<double> place(genome.variables.size());
    SobolPoints points(place.size(), task.seed);
    std::vector<Evolved> all(task.population);
    for (Evolved& one : all) {
      points.next(place);
      one.genes = genes_at(genome, place);
      one.costs = costs(one.genes);
    }
    return all;
  });
}

}  // namespace camlaw::optim
