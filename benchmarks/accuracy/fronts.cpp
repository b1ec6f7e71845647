// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/accuracy/accuracy.h"
#include "benchmarks/timing.h"
#include "optim/pareto/pareto.h"
#include "problems/fronts/known_fronts.h"

namespace camlaw::benchmarks {
namespace {

void print_row(const problems::KnownFront& known, const char* method, optim::ParetoMethod kind,
               std::size_t points) {
  optim::ParetoOptions options;
  options.points = points;
  options.method = kind;
  options.reference = known.reference;
  optim::Front front;
  const double spent = seconds([&] { front = optim::pareto(known.problem, options); });
  const auto certified = std::count_if(front.points.begin(), front.points.end(), [](const auto& p) {
    return p.verdict == optim::Verdict::Certified;
  });
  fmt::print("| {} | {} | {} | {} | {:.4f} | {} | {} | {} | {:.2f} |\n", known.problem.name, method,
             front.points.size(), certified, 100 * front.hypervolume / known.hypervolume,
             front.tasks, front.evaluations, front.failures.size(), spent);
  std::fflush(stdout);
}

}  // namespace

void print_known_fronts(std::size_t points) {
  fmt::print(
      "| problem | method | points | certified | hypervolume, % | searches | evaluations | "
      "failed | s |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const problems::KnownFront& known : problems::known_fronts()) {
    print_row(known, "sweep", optim::ParetoMethod::Sweep, points);
    print_row(known, "auto", optim::ParetoMethod::Automatic, points);
    print_row(known, "nsga2", optim::ParetoMethod::Nsga2, 100);
  }
}

}  // namespace camlaw::benchmarks
