// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/accuracy/accuracy.h"
#include "benchmarks/records/record_table.h"
#include "benchmarks/scale/simulated_cluster.h"
#include "benchmarks/timing.h"

namespace {

/// What a record is disturbed by, by its word on the command line.
camlaw::benchmarks::Disturbance disturbance_of(std::string_view word) {
  using camlaw::benchmarks::Disturbance;
  if (word == "drift") return Disturbance::Drift;
  if (word == "outliers") return Disturbance::Outliers;
  if (word == "once-per-turn") return Disturbance::OncePerTurn;
  return Disturbance::None;
}

/// --records FILE FIRST COUNT [drift|outliers|once-per-turn] and --record-table FILE...; whether
/// that was asked for.
bool run_records(int argc, char* argv[]) {
  namespace measures = camlaw::benchmarks;
  const std::string_view wanted = argc > 2 ? argv[1] : "";
  if (wanted == "--records" && (argc == 5 || argc == 6)) {
    measures::simulate_records(argv[2], std::strtoull(argv[3], nullptr, 10),
                               std::strtoull(argv[4], nullptr, 10),
                               disturbance_of(argc == 6 ? argv[5] : ""));
    return true;
  }
  if (wanted != "--record-table") return false;
  std::vector<measures::RecordVerdict> verdicts;
  for (int i = 2; i < argc; ++i) {
    const auto part = measures::read_verdicts(argv[i]);
    verdicts.insert(verdicts.end(), part.begin(), part.end());
  }
  fmt::print("{}", measures::record_table(verdicts));
  return true;
}

}  // namespace

/// camlaw_benchmarks --table prints the tables of speed of README.md, --accuracy those of accuracy.
/// --search, --cam-shape, --cams, --formulas, --means and --fronts print those tables of speed
/// alone,
/// --known-fronts and --even-fronts those tables of accuracy; --nist FOLDER that of NIST's
/// regression sets.
/// --records FILE FIRST COUNT fits simulated records into a file, --record-table FILE... prints
/// what such files hold. Any other arguments are Google Benchmark's (--benchmark_filter=peaks and
/// so on).
int main(int argc, char* argv[]) {
  namespace measures = camlaw::benchmarks;
  if (run_records(argc, argv)) return 0;
  const std::string_view wanted = argc == 2 ? argv[1] : "";
  if (argc == 3 && std::string_view(argv[1]) == "--nist") {
    measures::print_nist_table(argv[2]);
    return 0;
  }
  const bool all = wanted == "--table";
  if (all) {
    measures::print_law_tables();
    measures::print_peak_table();
    measures::print_study_table();
  }
  if (all || wanted == "--search") measures::print_search_table();
  if (all || wanted == "--cam-shape") measures::print_cam_shape_table();
  if (all || wanted == "--cams") measures::print_cam_table();
  if (all || wanted == "--formulas") measures::print_formula_table();
  if (all || wanted == "--means") measures::print_mean_table();
  if (all || wanted == "--fronts") measures::print_front_table();
  if (wanted == "--known-fronts") measures::print_known_fronts();
  if (wanted == "--even-fronts") measures::print_even_fronts();
  if (wanted == "--scale") measures::print_scale_table();
  if (wanted == "--accuracy") {
    measures::print_hock_schittkowski_table();
    measures::print_cam_shape_accuracy();
    measures::print_known_fronts();
    measures::print_even_fronts();
  }
  if (all || wanted == "--search" || wanted == "--cam-shape" || wanted == "--cams" ||
      wanted == "--formulas" || wanted == "--means" || wanted == "--fronts" ||
      wanted == "--known-fronts" || wanted == "--even-fronts" || wanted == "--scale" ||
      wanted == "--accuracy") {
    return 0;
  }
  measures::register_laws();
  measures::register_peaks();
  measures::register_study();
  measures::register_search();
  measures::register_cams();
  measures::register_constants();
  measures::register_fits();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
