// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <string_view>

#include "benchmarks/timing.h"

/// camlaw_benchmarks --table prints the tables of README.md; any other arguments are Google
/// Benchmark's (--benchmark_filter=peaks and so on).
int main(int argc, char* argv[]) {
  namespace measures = camlaw::benchmarks;
  if (argc == 2 && std::string_view(argv[1]) == "--table") {
    measures::print_law_tables();
    measures::print_peak_table();
    measures::print_study_table();
    return 0;
  }
  measures::register_laws();
  measures::register_peaks();
  measures::register_study();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
