// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/accuracy/accuracy.h"
#include "benchmarks/timing.h"
#include "tests/sets/nist/nist_runs.h"

namespace camlaw::benchmarks {

void print_nist_table(const std::string& folder) {
  std::vector<sets::NistRun> runs;
  const double spent = seconds([&] { runs = sets::nist_runs(folder); });
  fmt::print(
      "digits that agree with NIST's certified answers (11 at the most)\n\n"
      "| set | start | worst parameter | sum of squares | worst standard deviation | converged "
      "| iterations | evaluations |\n|---|--:|--:|--:|--:|---|--:|--:|\n");
  double sum = 0, worst = 11;
  for (const sets::NistRun& run : runs) {
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {} | {} | {} |\n", run.name, run.start,
               run.parameters, run.sum_of_squares, run.deviations,
               run.result.converged ? "yes" : "no", run.result.iterations, run.result.evaluations);
    sum += run.parameters;
    worst = std::min(worst, run.parameters);
  }
  fmt::print(
      "\nworst parameter: on average of {} runs {:.2f} digits, at least {:.1f}; {:.2f} s\n\n",
      runs.size(), sum / static_cast<double>(runs.size()), worst, spent);
}

}  // namespace camlaw::benchmarks
