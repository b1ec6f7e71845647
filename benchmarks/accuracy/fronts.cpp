// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/accuracy/accuracy.h"
#include "benchmarks/timing.h"
#include "optim/pareto/pareto.h"
#include "tests/sets/fronts/known_fronts.h"

namespace camlaw::benchmarks {
namespace {

/// How a front is looked for.
struct Way {
  const char* name;
  optim::ParetoMethod method;
  std::size_t points, population = 0, generations = 0;
};

void print_row(const sets::KnownFront& known, const Way& way) {
  optim::ParetoOptions options;
  options.points = way.points;
  options.method = way.method;
  options.population = way.population;
  options.generations = way.generations;
  options.reference = known.reference;
  optim::Front front;
  const double spent = seconds([&] { front = optim::pareto(known.problem, options); });
  fmt::print("| {} | {} | {} | {} | {:.3f} | {} | {} | {} | {:.1f} |\n", known.problem.name,
             way.name, front.points.size(), front.certified(),
             100 * front.hypervolume / known.hypervolume, front.tasks, front.evaluations,
             front.failures.size(), spent);
  std::fflush(stdout);
}

}  // namespace

void print_known_fronts() {
  fmt::print(
      "| problem | method | points | certified | hypervolume, % | searches | evaluations | failed "
      "| s |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const sets::KnownFront& known : sets::known_fronts()) {
    const bool three = known.problem.objectives.size() == 3;
    const std::size_t points = three ? 9000 : known.smooth ? 1000 : 600;
    if (known.smooth) print_row(known, {"sweep", optim::ParetoMethod::Sweep, points});
    if (!known.smooth) {
      print_row(known, {"auto", optim::ParetoMethod::Automatic, points, 200, 500});
    }
    const std::size_t population = three ? 1000 : 300;
    print_row(known, {"nsga2", optim::ParetoMethod::Nsga2, population, population, 500});
  }
}

}  // namespace camlaw::benchmarks
