// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/timing.h"
#include "optim/pareto/pareto.h"
#include "optim/pareto/scout.h"
#include "optim/study/workers.h"
#include "problems/fronts/front_study.h"
#include "problems/fronts/ruler.h"

namespace camlaw::benchmarks {
namespace {

constexpr const char* kMachine = R"(
mechanism = "spine-cutter"
[constants]
stroke = "40 mm"
depth = "1 mm"
[[objectives]]
minimize = "minimum_cam_radius"
reference = "44.1063 mm"
[[objectives]]
minimize = "peak_inertia_force"
reference = "12.238 N"
[[constraints]]
response = "peak_inertia_force"
upper = "12.238 N"
)";

struct Case {
  const char *name, *law;
};

constexpr Case kCases[] = {
    {"polynomial-5",
     "[law]\nname = \"polynomial-5\"\n[variables.alpha]\nlower = -10\nupper = 10\n"},
    {"legendre, order 9",
     "[law]\nname = \"legendre\"\n[variables.c]\nstart = [-1.8, 0, 0, 0]\nlower = -20\nupper = 20\n"
     "scale = 1\n"},
    {"free law, 16 knots", "[law]\nname = \"free\"\n[free]\ndegree = 2\nknots = 16\n"},
    {"free law, 64 knots", "[law]\nname = \"free\"\n[free]\ndegree = 2\nknots = 64\n"}};

/// Evaluations until NSGA-II reaches a hypervolume; none within the most that are allowed.
std::optional<long> evaluations_of_nsga2(const problems::FrontStudy& study, double wanted) {
  constexpr std::size_t kPopulation = 100, kMostGenerations = 1024;
  const optim::Problem problem = study.space().problem({});
  for (std::size_t generations = 1; generations <= kMostGenerations; generations *= 2) {
    optim::Task task;
    task.kind = optim::Task::Kind::Scout;
    task.population = kPopulation;
    task.generations = generations;
    const optim::Outcome outcome = optim::scout(task, problem);
    if (optim::hypervolume(optim::costs_of(outcome.points), *study.options().reference) >= wanted)
      return outcome.evaluations;
  }
  return {};
}

void print_case(const Case& one) {
  constexpr std::size_t kPoints = 50;
  const problems::FrontStudy study(std::string(kMachine) + one.law, one.name,
                                   {kPoints, optim::ParetoMethod::Sweep});
  optim::Front front;
  const double alone = seconds([&] { front = optim::pareto(study.space(), study.options()); });
  optim::ProcessExecutor workers(study.space(), study.options().solve, 2);
  const double shared = seconds([&] { study.run(workers); });
  const auto ruler = problems::front_ruler(study.bound().statement());
  const double most = ruler->hypervolume(front.reference);
  const auto scouted = evaluations_of_nsga2(study, front.hypervolume);
  const long at_most = 100 * 1025;
  fmt::print(
      "| {} | {} | {} | {:.2f} | {:.2f} | {:.3f} | {} | {} | {}{:.1f} |\n", one.name,
      front.points.size(), front.certified(), alone, shared,
      100 * front.hypervolume_of_mixtures.value_or(front.hypervolume) / most, front.evaluations,
      scouted ? fmt::format("{}", *scouted) : "not reached", scouted ? "" : "> ",
      static_cast<double>(scouted.value_or(at_most)) / static_cast<double>(front.evaluations));
  std::fflush(stdout);
}

}  // namespace

void print_front_table() {
  fmt::print(
      "| spine cutter, law | points | certified | s, one process | s, two | of the limit, % | "
      "evaluations | NSGA-II to the same hypervolume | ratio |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const Case& one : kCases) print_case(one);
}

}  // namespace camlaw::benchmarks
