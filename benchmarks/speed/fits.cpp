// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <utility>

#include "benchmarks/timing.h"
#include "fitting/constants/constants_fit.h"
#include "fitting/motions/law_ranking.h"

/// A lift table of 1000 points, a motion with noise of a thousandth of its stroke, to one law, to a
/// family with its coefficient, and to every law of the catalogue.
namespace camlaw::benchmarks {
namespace {

problems::MotionSamples table() {
  constexpr int kCount = 1000;
  problems::MotionSamples samples;
  const Law<double> law = find_law("modified-sine").law();
  std::mt19937_64 random(1);  // the same numbers in every run
  for (int i = 0; i < kCount; ++i) {
    const double noise = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
    samples.place.push_back(90.0 * i / (kCount - 1));
    samples.value.push_back(20 * (law(i / (kCount - 1.0)).s + 0.001 * noise));
  }
  samples.place_unit = "deg";
  samples.unit = "mm";
  return samples;
}

void fit_one(benchmark::State& state, const char* name) {
  const auto samples = table();
  const Member law = find_law(name);
  const auto guess = problems::guess_motion(samples);
  for ([[maybe_unused]] const auto pass : state) {
    auto fit = problems::fit_law(samples, law, guess);
    benchmark::DoNotOptimize(fit);
  }
}

void fit_all(benchmark::State& state) {
  const auto samples = table();
  const auto laws = problems::laws_to_try();
  const auto guess = problems::guess_motion(samples);
  for ([[maybe_unused]] const auto pass : state) {
    auto ranking = problems::rank_fits(samples, laws, guess).fits;
    benchmark::DoNotOptimize(ranking);
  }
}

}  // namespace

void register_fits() {
  for (const char* name :
       {"modified-sine", "polynomial-5", "fourier", "scca", "universal", "elliptic"}) {
    benchmark::RegisterBenchmark((std::string("fit/") + name).c_str(),
                                 [name](benchmark::State& state) { fit_one(state, name); })
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("fit/every-law", fit_all)->Unit(benchmark::kMillisecond);
}

}  // namespace camlaw::benchmarks
