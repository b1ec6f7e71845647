// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

/// Timing for the tables: medians of repetitions, so that a busy machine moves them little.
namespace camlaw::benchmarks {

/// Seconds that `passes` calls of `work` take.
template <class Work>
double seconds(Work&& work, int passes = 1) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < passes; ++i) work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The same of the processor's time for this program, which other programs move less.
template <class Work>
double processor_seconds(Work&& work, int passes = 1) {
  const std::clock_t start = std::clock();
  for (int i = 0; i < passes; ++i) work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The value that part `q` of the values lies below: 0.5 for the median.
inline double quantile(std::vector<double> values, double q) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(q * last + 0.5);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

/// The tables of README.md, printed to standard output. Each file that measures has one.
void print_law_tables();
void print_peak_table();
void print_study_table();
void print_search_table();
void print_cam_shape_table();
void print_cam_table();
void print_formula_table();
void print_mean_table();
void print_front_table();

/// Adds the measures of a file to Google Benchmark's list.
void register_laws();
void register_peaks();
void register_study();
void register_search();
void register_cams();
void register_constants();
void register_fits();

}  // namespace camlaw::benchmarks
