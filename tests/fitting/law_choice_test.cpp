// SPDX-License-Identifier: MIT
// Which law is named, what else may be behind the samples, and how far intervals hold after that.
#include "fitting/motions/law_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "benchmarks/records/record_table.h"
#include "fitting/constants/constants_fit.h"
#include "fitting/motions/fitted_cycle.h"
#include "fitting/motions/law_ranking.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::law_choice_test {
namespace {

using testing::Random;

/// A law from 20 to 110 deg over 12 mm from 1 mm, with rests of 15 deg; rounded to `step`.
MotionSamples record(const std::string& law_name, std::size_t count, double noise, unsigned seed,
                     int order = 0, double step = 0) {
  const Law<double> law = find_law(law_name).law();
  Random random(seed);
  MotionSamples samples;
  samples.order = order;
  samples.place_unit = "deg";
  samples.resolution = step;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = 5 + 120 * static_cast<double>(i) / static_cast<double>(count - 1);
    const double u = (place - 20) / 90;
    const bool moves = u > 0 && u < 1;
    const auto d = law.derivatives<3>(std::clamp(u, 0.0, 1.0), u < 1 ? Side::Right : Side::Left);
    double value = order == 0 ? 1 + 12 * d[0] : 0;
    if (order > 0 && moves) value = 12 * d[static_cast<std::size_t>(order)] / std::pow(90, order);
    value += noise * random.normal();
    samples.place.push_back(place);
    samples.value.push_back(step > 0 ? step * std::round(value / step) : value);
  }
  return samples;
}

MotionFit fitted(const MotionSamples& samples) {
  return fit_cycle(find_motions(samples), laws_to_try()).fits.front();
}

bool is_named(const MotionFit& fit, const std::string& family) {
  if (fit.best().law.family->name == family) return true;
  return std::any_of(fit.as_good.begin(), fit.as_good.end(),
                     [&](const std::string& name) { return name.rfind(family, 0) == 0; });
}

const optim::FittedParameter& parameter(const LawFit& fit, const std::string& name) {
  return *std::find_if(fit.fit.parameters.begin(), fit.fit.parameters.end(),
                       [&](const auto& p) { return p.name == name; });
}

}  // namespace

TEST_CASE("a skewed law comes back as itself", "[law-choice][long]") {
  for (const char* name : {"modified-sine", "cycloidal"}) {
    const MotionFit fit = fitted(record(fmt::format("{} crossover=0.4", name), 150, 0.002, 3));
    CAPTURE(name, fit.best().law.label());
    CHECK(fit.best().law.family->name == name);
    CHECK(fit.distrust.empty());
    const auto& crossover = parameter(fit.best(), "crossover");
    CHECK(crossover.value == Approx(0.4).margin(0.002));
    CHECK(crossover.low < 0.4);
    CHECK(crossover.high > 0.4);
  }
}

TEST_CASE("a law without coefficients is named before those that hold it", "[law-choice][heavy]") {
  for (const char* name : {"modified-sine", "cycloidal", "poly-4-5-6-7", "constant-velocity"}) {
    const MotionFit fit = fitted(record(name, 200, 0.002, 1));
    CAPTURE(name, fit.best().law.label());
    CHECK(fit.best().law.name() == name);
    CHECK(fit.distrust.empty());
    CHECK(fit.as_good.size() <= 5);
  }
}

TEST_CASE(
    "where noise does not tell laws apart the right one is among those listed, and intervals "
    "are wide",
    "[law-choice][heavy]") {
  int held = 0, intervals = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const MotionFit fit = fitted(record("cycloidal", 90, 0.09, seed));
    CAPTURE(seed, fit.best().law.label());
    CHECK(is_named(fit, "cycloidal"));
    CHECK_FALSE(fit.as_good.empty());
    for (const auto& [name, truth] : {std::pair{"begin", 20.0}, std::pair{"end", 110.0}}) {
      const auto& p = parameter(fit.best(), name);
      ++intervals, held += p.low <= truth && truth <= p.high;
    }
  }
  CHECK(held >= intervals - 1);
}

TEST_CASE("weights share the belief among laws of one complexity", "[law-choice]") {
  const Member law = find_law("cycloidal");
  std::vector<LawFit> fits(5, LawFit{law, {}});
  for (std::size_t i = 0; i < fits.size(); ++i) fits[i].numbers = i < 2 ? 4 : i < 4 ? 5 : 6;
  weigh(fits);
  // By hand: shares 1, 1/3 and 1/9 of the belief, halved where two laws have it.
  const double all = 1 + 1.0 / 3 + 1.0 / 9;
  CHECK(fits[0].weight == Approx(0.5 / all));
  CHECK(fits[3].weight == Approx(1.0 / 6 / all));
  CHECK(fits[4].weight == Approx(1.0 / 9 / all));
}

TEST_CASE("deviations say what the intervals say, whatever unlikely laws would have",
          "[law-choice]") {
  // The quintic at alpha = -10 is the 3-4-5, and its ends are as good as not determined.
  const MotionSamples samples = record("poly-3-4-5", 131, 0.007, 6);
  const std::vector<Member> laws{find_law("poly-3-4-5"), find_law("polynomial-5")};
  const LawFit fit = fit_cycle(find_motions(samples), laws).fits.front().best();
  CHECK(fit.law.name() == "poly-3-4-5");
  const double t = optim::student_quantile(fit.fit.degrees_of_freedom, 0.95);
  for (const char* name : {"begin", "end", "stroke", "zero"}) {
    INFO(name);
    const auto& p = parameter(fit, name);
    CHECK(p.standard_deviation == Approx((p.high - p.low) / (2 * t)));
    CHECK(p.standard_deviation < 0.1);
  }
}

TEST_CASE("the unit of an acceleration does not choose a law that nothing determines",
          "[law-choice]") {
  // Its free ends make boundary-7 the same curve over any stretch.
  const std::vector<Member> laws{find_law("poly-3-4-5"), find_law("boundary-7")};
  for (const double unit : {1e-3, 1.0, 1e3, 1e6}) {
    INFO("values times " << unit);
    MotionSamples samples = record("poly-3-4-5", 131, 5e-5, 3, 2);
    for (double& a : samples.value) a *= unit;
    const auto ranking = rank_fits(samples, laws, guess_motion(samples)).fits;
    CHECK(ranking.front().law.name() == "poly-3-4-5");
    CHECK(ranking.front().weight > 0.9);
  }
}

TEST_CASE("all samples of a record with one motion count", "[law-choice]") {
  const MotionSamples samples = record("cycloidal", 240, 0.005, 4);
  const FoundCycle cycle = find_motions(samples);
  REQUIRE(cycle.motions.size() == 1);
  CHECK(cycle.segments.size() == 3);
  CHECK(cycle.motions[0].samples.place.size() == 240);
}

TEST_CASE("velocities and accelerations that jump are fitted", "[law-choice]") {
  struct Case {
    const char* law;
    int order;
  };
  for (const Case& c :
       {Case{"constant-velocity", 1}, Case{"cubic", 2}, Case{"cosine", 2}, Case{"parabolic", 2}}) {
    const double peak = c.order == 1 ? 12.0 / 90 : 12 * 5.0 / (90 * 90);
    const MotionSamples samples = record(c.law, 181, 0.003 * peak, 5, c.order);
    const LawFit fit = fit_law(samples, find_law(c.law), guess_motion(samples));
    CAPTURE(c.law, fit.fit.reason);
    CHECK(fit.fit.reason_but_bounds.empty());
    CHECK(fit.fit.rms < 1.2 * 0.003 * peak);
    const double spacing = 120.0 / 180;
    CHECK(fit.begin == Approx(20).margin(spacing));
    CHECK(fit.end == Approx(110).margin(spacing));
    const auto& begin = parameter(fit, "begin");
    CHECK(begin.high - begin.low < 2 * spacing);
  }
}

TEST_CASE("intervals of ends at which values jump reach over the gap between samples",
          "[law-choice]") {
  // Any end between two samples makes the same accelerations, rounded or not; 20 and 110 deg are
  // the abscissas of none.
  const double peak = 12 * 4.0 / (90 * 90);
  for (const double step : {0.0, 1e-5 * peak}) {
    const MotionSamples samples = record("parabolic", 122, 0.003 * peak, 5, 2, step);
    const std::vector<Member> laws{find_law("parabolic")};
    const LawFit fit = fit_cycle(find_motions(samples), laws).fits.front().best();
    const double gap = 120.0 / 121;
    for (const auto& [name, truth] : {std::pair{"begin", 20.0}, std::pair{"end", 110.0}}) {
      const auto& end = parameter(fit, name);
      CAPTURE(step, name, end.value, end.low, end.high);
      CHECK(end.low < truth);
      CHECK(end.high > truth);
      CHECK(end.high - end.low > 0.9 * gap);
      CHECK(end.high - end.low < 1.2 * gap);
    }
  }
}

TEST_CASE("equal families end in equal minima", "[law-choice]") {
  for (unsigned seed = 1; seed < 5; ++seed) {
    const MotionSamples samples = record("fourier a=0.05,0.03", 160, 0.004, seed);
    const std::vector<Member> laws{find_law("fourier"), find_law("triple-harmonic"),
                                   find_law("cycloidal")};
    const auto ranking = rank_fits(samples, laws, guess_motion(samples)).fits;
    double fourier = 0, triple = 0;
    for (const LawFit& fit : ranking) {
      if (fit.skew == Skew::Free) continue;
      if (fit.law.family->name == "fourier") fourier = fit.fit.sum_of_squares;
      if (fit.law.family->name == "triple-harmonic") triple = fit.fit.sum_of_squares;
    }
    CAPTURE(seed);
    CHECK(triple == Approx(fourier).epsilon(1e-6));
  }
}

TEST_CASE("intervals hold where values are rounded more coarsely than they scatter",
          "[law-choice][heavy]") {
  // With 60 samples in the rests their mean is no nearer than one of them.
  int held = 0, intervals = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(1000 + seed);
    MotionSamples samples = record("poly-3-4-5", 240, 0.0004, seed);
    const double shift = random(0, 0.01), scale = random(0.9, 1.1);
    samples.resolution = 0.01;
    for (double& y : samples.value) y = 0.01 * std::round((scale * y + shift) / 0.01);
    const LawFit fit = fit_law(samples, find_law("poly-3-4-5"), guess_motion(samples));
    for (const auto& [name, truth] :
         {std::pair{"begin", 20.0}, std::pair{"end", 110.0}, std::pair{"stroke", 12 * scale},
          std::pair{"zero", scale + shift}}) {
      const auto& p = parameter(fit, name);
      ++intervals, held += p.low <= truth && truth <= p.high;
    }
  }
  // 228 of 240 expected; independent errors would hold some 190.
  CHECK(intervals == 240);
  CHECK(held >= 216);
}

TEST_CASE("simulated records: the right law is told or listed, and trust is deserved",
          "[law-choice][heavy]") {
  benchmarks::RecordTally tally;
  for (std::uint64_t number = 20008; number < 20012; ++number) {
    tally.add(benchmarks::verdict_of_line(benchmarks::line_of(benchmarks::verdict_of(number))));
  }
  CHECK(tally.records == 4);
  CHECK(tally.split == 0);
  CHECK(tally.among >= tally.records - 1);
  CHECK(tally.false_trust == 0);
  CHECK(static_cast<double>(tally.held) >= 0.85 * static_cast<double>(tally.intervals));
}

}  // namespace camlaw::problems::law_choice_test
