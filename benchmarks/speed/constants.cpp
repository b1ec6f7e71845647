// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <utility>

#include "benchmarks/timing.h"
#include "fitting/constants/constants_fit.h"

/// One question of printed constants to every law of the catalogue: of a fixed law, of a member of
/// a family, and of numbers that no law prints.
namespace camlaw::benchmarks {
namespace {

void ask(benchmark::State& state, const char* printed) {
  problems::ConstantsQuestion question{problems::law_alone(), {}};
  question.constants = problems::parse_constants(printed, *question.machine.mechanism);
  const auto laws = problems::laws_to_try();
  for ([[maybe_unused]] const auto pass : state) {
    auto fits = problems::rank_laws(question, laws);
    benchmark::DoNotOptimize(fits);
  }
}

}  // namespace

void register_constants() {
  for (const auto& [name, printed] : {std::pair{"constants/fixed-law", "B=1.76, C=5.528, D=69.47"},
                                      std::pair{"constants/family", "B=1.67, C=5.73, D=59.98"},
                                      std::pair{"constants/no-law", "B=1.78, C=5.77, D=62.2"}}) {
    benchmark::RegisterBenchmark(name, [printed = printed](benchmark::State& state) {
      ask(state, printed);
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace camlaw::benchmarks
