// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "benchmarks/accuracy/accuracy.h"
#include "benchmarks/timing.h"
#include "optim/pareto/pareto.h"
#include "optim/pareto/scout.h"
#include "problems/fronts/front_study.h"
#include "tests/sets/fronts/surfaces.h"

namespace camlaw::benchmarks {
namespace {

/// NSGA-II with as many designs as the front has points, for each combination of choices.
struct Evolved {
  double best = 0;       ///< hypervolume of five seeds
  long evaluations = 0;  ///< of one seed
};

Evolved evolved(const optim::ProblemSpace& space, std::size_t points, std::size_t generations,
                const optim::Costs& reference) {
  Evolved result;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::vector<optim::Costs> all;
    result.evaluations = 0;
    for (std::size_t part = 0; part < space.parts(); ++part) {
      optim::Task task;
      task.kind = optim::Task::Kind::Scout;
      task.part = part;
      task.population = points;
      task.generations = generations;
      task.seed = seed;
      const optim::Outcome outcome = optim::scout(task, space.problem(space.options(part)));
      result.evaluations += outcome.evaluations;
      for (const optim::FrontPoint& p : outcome.points) all.push_back(p.costs);
    }
    result.best = std::max(result.best, optim::hypervolume(all, reference));
  }
  return result;
}

void print_row(const std::string& name, const optim::ProblemSpace& space,
               const optim::ParetoOptions& options) {
  constexpr std::size_t kGenerations = 250;
  optim::Front front;
  const double spent = seconds([&] { front = optim::pareto(space, options); });
  const Evolved other = evolved(space, options.points, kGenerations, front.reference);
  fmt::print("| {} | {}, {} | {:.2f} | {} | {:.4f} | {} | {} | {} | {:.2f} |\n", name,
             front.points.size(), front.certified(), front.largest_gap.value_or(0),
             front.complete ? "yes" : "no", front.hypervolume / other.best, other.evaluations,
             front.tasks, front.evaluations, spent);
  std::fflush(stdout);
}

}  // namespace

void print_even_fronts() {
  fmt::print(
      "| front | points, certified | largest gap / mean | complete | hypervolume / NSGA-II's best "
      "of five | its evaluations, each | searches | evaluations | s |\n"
      "|---|--:|--:|---|--:|--:|--:|--:|--:|\n");
  for (const std::size_t objectives : {3, 4, 5}) {
    for (const char* name : {"sphere", "centres", "inverted", "patches", "curve"}) {
      const auto surface = sets::known_surface(name, objectives);
      optim::ParetoOptions options;
      options.points = objectives == 3 ? 40 : 100;
      print_row(surface.problem.name, optim::ProblemSpace::of(surface.problem), options);
    }
  }
  for (const auto& [name, points] :
       {std::pair("roller_front", 40), std::pair("roller_four", 100)}) {
    const std::string file = fmt::format("{}/problems/cams/{}.toml", CAMLAW_SOURCE_DIR, name);
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    problems::FrontSettings settings;
    settings.points = static_cast<std::size_t>(points);
    const problems::FrontStudy study(text.str(), file, settings);
    print_row(fmt::format("{}.toml", name), study.space(), study.options());
  }
}

}  // namespace camlaw::benchmarks
