// SPDX-License-Identifier: MIT
#include "kinematics/peaks.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "benchmarks/timing.h"
#include "kinematics/laws/catalogue.h"

/// Exact peaks of every law of the catalogue at its default arguments, as numbers and proved.
namespace camlaw::benchmarks {
namespace {

struct Row {
  std::string law;
  bool data;
  double plain, proved;  ///< microseconds
};

template <class T>
double microseconds(const Law<T>& law) {
  constexpr int kRepetitions = 101;
  const auto run = [&] {
    auto result = peaks(law);
    benchmark::DoNotOptimize(result);
  };
  const int passes = std::max(1, static_cast<int>(200e-6 / seconds(run, 2) * 2));
  std::vector<double> times;
  for (int i = 0; i < kRepetitions; ++i) times.push_back(seconds(run, passes) / passes * 1e6);
  return median(times);
}

/// NaN where the law cannot be made in this scalar.
template <class T>
double microseconds(const Family& family) {
  try {
    return microseconds(family.make(family.defaults().as<T>()));
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "{}\n", error.what());
    return std::numeric_limits<double>::quiet_NaN();
  }
}

Row measure(const Family& family) {
  return {family.name, family.make(family.defaults()).is_data(), microseconds<double>(family),
          microseconds<Interval>(family)};
}

/// The largest time among the laws that are data, which the targets are for.
double worst(const std::vector<Row>& rows, double Row::*time) {
  double result = 0;
  for (const Row& row : rows) {
    if (row.data) result = std::max(result, row.*time);
  }
  return result;
}

}  // namespace

void print_peak_table() {
  std::vector<Row> rows;
  for (const Family& family : catalogue()) rows.push_back(measure(family));
  const auto key = [](const Row& row) { return std::isnan(row.proved) ? 0 : row.proved; };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const Row& a, const Row& b) { return key(a) > key(b); });
  const double plain = worst(rows, &Row::plain), proved = worst(rows, &Row::proved);
  fmt::print("peaks, microseconds (** the slowest law that is data)\n\n");
  fmt::print("| law | data | peaks | with enclosure |\n|---|---|--:|--:|\n");
  for (const Row& row : rows) {
    fmt::print("| {} | {} | {:.1f}{} | {:.1f}{} |\n", row.law, row.data ? "yes" : "no", row.plain,
               row.data && row.plain == plain ? " **" : "", row.proved,
               row.data && row.proved == proved ? " **" : "");
  }
  fmt::print("\n");
}

namespace {

template <class T>
void register_one(const Family& family, const char* kind) {
  const auto name = fmt::format("peaks/{}/{}", family.name, kind);
  benchmark::RegisterBenchmark(name.c_str(), [&family](benchmark::State& state) {
    const Law<T> law = family.make(family.defaults().as<T>());
    for ([[maybe_unused]] const auto pass : state) {
      auto result = peaks(law);
      benchmark::DoNotOptimize(result);
    }
  });
}

}  // namespace

void register_peaks() {
  for (const Family& family : catalogue()) {
    register_one<double>(family, "plain");
    register_one<Interval>(family, "enclosed");
  }
}

}  // namespace camlaw::benchmarks
