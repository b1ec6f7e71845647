// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/timing.h"
#include "optim/cycle/extremes.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

/// The spine cutter's problem files, each from the bound problem to the certified optimum.
namespace camlaw::benchmarks {
namespace {

constexpr const char* kFiles[] = {"least_radius", "least_force", "least_force_legendre",
                                  "least_moment", "cutter"};

problems::BoundProblem bound(const char* name) {
  const std::filesystem::path folder = CAMLAW_SOURCE_DIR "/problems/spine_cutter";
  return problems::BoundProblem(
      problems::read_problem_file((folder / (std::string(name) + ".toml")).string()));
}

optim::Optimum solved(const problems::BoundProblem& problem) {
  const auto& file = problem.statement().solver;
  optim::OptimiseOptions options;
  options.solver = file.name.value_or("auto");
  options.starts = file.starts;
  options.seed = file.seed.value_or(options.seed);
  options.native = file.native;
  return optim::optimise(problem.space(), options);
}

/// Seconds that the objective, of a curve its peak, and its gradient there take at a design.
double one_evaluation(const optim::Problem& problem, const std::vector<double>& x) {
  const optim::Response& response = problem.objective().response;
  std::vector<double> gradient;
  const auto work = [&] {
    if (response.is_curve()) {
      const auto place = optim::highest(*response.curve().trace(x), 1).place;
      const optim::Function f = response.curve().at(place);
      gradient.resize(f.inputs().size());
      benchmark::DoNotOptimize(f.gradient(x, gradient));
    } else {
      gradient.resize(response.function().inputs().size());
      benchmark::DoNotOptimize(response.function().gradient(x, gradient));
    }
  };
  constexpr int kPasses = 200;
  std::vector<double> times;
  for (int i = 0; i < 11; ++i) times.push_back(seconds(work, kPasses) / kPasses);
  return median(times);
}

}  // namespace

void print_search_table() {
  fmt::print(
      "the spine cutter's problem files to the verdict\n\n"
      "| file | verdict | ms | quartiles | programs solved | evaluations | us per objective and "
      "gradient |\n|---|---|--:|--:|--:|--:|--:|\n");
  for (const char* name : kFiles) {
    const auto problem = bound(name);
    const optim::Optimum optimum = solved(problem);
    std::vector<double> times;
    for (int i = 0; i < 11; ++i) times.push_back(1e3 * seconds([&] { solved(problem); }));
    fmt::print("| {} | {} | {:.2f} | {:.2f} to {:.2f} | {} | {} | {:.1f} |\n", name,
               optim::to_string(optimum.found.assessment.verdict), median(times),
               quantile(times, 0.25), quantile(times, 0.75), optimum.found.solves,
               optimum.found.evaluations, 1e6 * one_evaluation(optimum.problem, optimum.found.x));
  }
  fmt::print("\n");
}

void register_search() {
  for (const char* name : kFiles) {
    benchmark::RegisterBenchmark((std::string("search/") + name).c_str(),
                                 [name](benchmark::State& state) {
                                   const auto problem = bound(name);
                                   for ([[maybe_unused]] const auto pass : state) {
                                     auto optimum = solved(problem);
                                     benchmark::DoNotOptimize(optimum);
                                   }
                                 })
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace camlaw::benchmarks
