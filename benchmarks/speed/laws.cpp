// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "benchmarks/speed/hand_laws.h"
#include "benchmarks/timing.h"
#include "kinematics/laws/catalogue.h"
#include "kinematics/spans/law_span.h"

/// s, v, a, j of many points: our loop against loops written by hand.
namespace camlaw::benchmarks {
namespace {

constexpr std::size_t kPoints = 4096;

struct Contest {
  const char* law;
  HandLoop hand;
};

constexpr Contest kContests[] = {{"poly-3-4-5", hand_poly_3_4_5},
                                 {"poly-4-5-6-7", hand_poly_4_5_6_7},
                                 {"cycloidal", hand_cycloidal},
                                 {"modified-sine", hand_modified_sine}};

/// Four curves in one block, each a few cache lines further than the one before. At equal places in
/// their pages a processor takes a load of one for waiting on the store of another.
class Curves {
 public:
  MotionSpans spans() { return {curve(0), curve(1), curve(2), curve(3)}; }

 private:
  static constexpr std::size_t kGap = 64;
  std::span<double> curve(std::size_t i) {
    return std::span(values_).subspan((i + 1) * kGap + i * kPoints, kPoints);
  }
  std::vector<double> values_ = std::vector<double>(4 * (kPoints + kGap) + kGap);
};

std::vector<double> points(bool shuffled) {
  std::vector<double> x(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) x[i] = static_cast<double>(i) / (kPoints - 1);
  if (shuffled) std::shuffle(x.begin(), x.end(), std::mt19937_64(1));
  return x;
}

double difference(std::span<const double> one, std::span<const double> other) {
  double largest = 0, size = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    largest = std::max(largest, std::abs(one[i] - other[i]));
    size = std::max(size, std::abs(other[i]));
  }
  return largest / size;
}

/// A loop is only worth timing if it computes the law.
void check_same(const char* name, MotionSpans ours, MotionSpans hand) {
  const double worst = std::max({difference(ours.s, hand.s), difference(ours.v, hand.v),
                                 difference(ours.a, hand.a), difference(ours.j, hand.j)});
  if (!(worst < 1e-12)) {
    throw std::logic_error(fmt::format("{}: the two loops differ by {:.1e}", name, worst));
  }
}

struct Result {
  double ours, hand;        ///< ns per point, medians
  double ratio, low, high;  ///< median and quartiles of the paired repetitions
};

/// Times both loops turn by turn, the first of a pair changing, on the same buffers.
Result race(const Contest& contest, const std::vector<double>& x) {
  constexpr int kPairs = 401, kPasses = 10;
  const Law<double> law = find_law(contest.law).law();
  Curves ours, hand;
  evaluate(law, x, ours.spans());
  contest.hand(x, hand.spans());
  check_same(contest.law, ours.spans(), hand.spans());
  const auto run = [&](bool own) {
    own ? evaluate(law, x, ours.spans()) : contest.hand(x, ours.spans());
    benchmark::DoNotOptimize(&ours);
    benchmark::ClobberMemory();
  };
  std::vector<double> times[2], ratios;
  for (int pair = 0; pair < kPairs; ++pair) {
    for (const bool own : {pair % 2 == 0, pair % 2 != 0}) {
      run(own);  // brings code and branch history back
      times[own].push_back(seconds([&] { run(own); }, kPasses) / kPasses / kPoints * 1e9);
    }
    ratios.push_back(times[true].back() / times[false].back());
  }
  return {median(times[true]), median(times[false]), median(ratios), quantile(ratios, 0.25),
          quantile(ratios, 0.75)};
}

/// A spline of ten pieces of degree 5.
constexpr const char* kSpline =
    "b-spline degree=5 knots=.1,.2,.3,.4,.5,.6,.7,.8,.9 "
    "coefficients=0,0,0,.1,.2,.25,.4,.5,.6,.7,.8,.9,1,1,1";

/// ns per point, the least of many runs.
double time_of(const SpanKernels& kernels, const Law<double>& law, const std::vector<double>& x) {
  Curves curves;
  double least = 1e9;
  for (int run = 0; run < 101; ++run) {
    least = std::min(least, seconds(
                                [&] {
                                  evaluate_by(kernels, law, x, curves.spans());
                                  benchmark::DoNotOptimize(&curves);
                                  benchmark::ClobberMemory();
                                },
                                10));
  }
  return least / 10 / kPoints * 1e9;
}

void print_instruction_sets() {
  fmt::print("s, v, a, j by instruction set, ns/point, sorted and shuffled\n\n| law |");
  for (const SpanKernels* kernels : span_kernels()) fmt::print(" {} |", kernels->instruction_set);
  fmt::print("\n|---|");
  for (std::size_t i = 0; i < span_kernels().size(); ++i) fmt::print("--:|");
  for (const char* name : {"poly-3-4-5", "poly-4-5-6-7", "cycloidal", "modified-sine",
                           "modified-trapezoid", "scca", "gutman-1-3", "table", kSpline}) {
    const Law<double> law = find_law(name).law();
    const bool is_spline = name == kSpline;
    fmt::print("\n| {} |", is_spline ? "b-spline, ten pieces of degree 5" : name);
    for (const SpanKernels* kernels : span_kernels()) {
      fmt::print(" {:.2f}, {:.2f} |", time_of(*kernels, law, points(false)),
                 time_of(*kernels, law, points(true)));
    }
  }
  fmt::print("\n\n");
}

}  // namespace

void print_law_tables() {
  for (const bool shuffled : {false, true}) {
    fmt::print("s, v, a, j of {} {} points\n\n", kPoints, shuffled ? "shuffled" : "even, sorted");
    fmt::print("| law | ours, ns/point | by hand, ns/point | ratio | its quartiles |\n");
    fmt::print("|---|--:|--:|--:|--:|\n");
    const auto x = points(shuffled);
    for (const Contest& contest : kContests) {
      const Result r = race(contest, x);
      fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} to {:.2f} |\n", contest.law, r.ours,
                 r.hand, r.ratio, r.low, r.high);
    }
    fmt::print("\n");
  }
  print_instruction_sets();
}

void register_laws() {
  for (const bool shuffled : {false, true}) {
    for (const Contest& contest : kContests) {
      for (const bool own : {true, false}) {
        const auto name = fmt::format("span/{}/{}/{}", contest.law,
                                      shuffled ? "shuffled" : "sorted", own ? "ours" : "hand");
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
          const Law<double> law = find_law(contest.law).law();
          const auto x = points(shuffled);
          Curves curves;
          for ([[maybe_unused]] const auto pass : state) {
            own ? evaluate(law, x, curves.spans()) : contest.hand(x, curves.spans());
            benchmark::DoNotOptimize(&curves);
            benchmark::ClobberMemory();
          }
          state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPoints));
        });
      }
    }
  }
}

}  // namespace camlaw::benchmarks
