// SPDX-License-Identifier: MIT
// Few samples that stand for very many, and fits by them.
#include "fitting/samples/stand_ins.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/law_fit.h"
#include "fitting/motions/law_residuals.h"
#include "fitting/samples/condensed.h"
#include "tests/fitting/sampled_motion.h"

namespace camlaw::problems::stand_ins_test {
namespace {

using testing::rough;

/// How the places of samples lie.
enum class Spread { Even, Uneven, Shuffled, Repeated, Gap };

std::vector<double> places(Spread spread, std::size_t count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<> even;
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) {
    double share = (static_cast<double>(i) + 0.37) / static_cast<double>(count);
    if (spread == Spread::Uneven) share = std::pow(share, 4);
    if (spread == Spread::Repeated) share = std::floor(700 * share) / 700;
    if (spread == Spread::Gap && share > 0.3) share = 0.6 + 0.4 * (share - 0.3) / 0.7;
    result.push_back(150 * share);
  }
  if (spread == Spread::Shuffled) std::shuffle(result.begin(), result.end(), random);
  return result;
}

MotionSamples sampled(const Law<double>& law, Spread spread, double noise, int order,
                      std::size_t count = 12000) {
  return testing::sampled_at(places(spread, count), law, noise, 3, order);
}

constexpr Spread kSpreads[] = {Spread::Even, Spread::Uneven, Spread::Shuffled, Spread::Repeated,
                               Spread::Gap};

}  // namespace

TEST_CASE("few samples leave of a curve what the many leave that they stand for", "[stand-ins]") {
  for (const Spread spread : kSpreads) {
    const MotionSamples samples = sampled(find_law("cycloidal").law(), spread, 0.01, 0);
    const SampleBlocks blocks(samples, -20, 170);
    const std::vector<double> breaks{10, 60};
    const StandIns few = blocks.stand_ins(breaks);
    INFO("spread " << static_cast<int>(spread));
    CHECK(few.samples.place.size() < samples.place.size() / 4);
    CHECK(few.all == samples.place.size());
    double standing = 0;
    for (const double root : few.roots) standing += root * root;
    CHECK(standing == Approx(few.all).epsilon(1e-12));
    const auto left = [&](const auto& curve) {
      double all = 0, own = few.rest;
      for (std::size_t i = 0; i < samples.place.size(); ++i) {
        all += std::pow(curve(samples.place[i]) - samples.value[i], 2);
      }
      for (std::size_t i = 0; i < few.samples.place.size(); ++i) {
        own += std::pow(few.roots[i] * (curve(few.samples.place[i]) - few.samples.value[i]), 2);
      }
      CHECK(own == Approx(all).epsilon(1e-11));
    };
    left([](double) { return 0.0; });
    left([](double x) { return 3 + x / 10; });
    left([](double x) { return std::pow(x / 40, 4) - std::pow(x / 50, 3); });
    left([](double x) { return 12 + 10 * std::sin(x / 20); });
    // Where derivatives jump in or beside a block its samples stand for themselves.
    left([](double x) { return std::max(0.0, x - 10) + std::max(0.0, x - 60); });
    CHECK(blocks.are_for(breaks, breaks));
    CHECK_FALSE(blocks.are_for({}, breaks));
    CHECK(blocks.are_for({}, {}));
  }
}

TEST_CASE("fits by stand-ins are those of all samples", "[stand-ins][law-fit]") {
  struct Case {
    const char* name;
    int order;
    double noise;
  };
  for (const Case& c : std::vector<Case>{{"cycloidal", 0, 1e-3},
                                         {"modified-sine", 0, 1e-5},
                                         {"modified-trapezoid", 0, 0.3},
                                         {"constant-velocity", 0, 1e-3},
                                         {"parabolic", 0, 1e-3},
                                         {"polynomial-5 alpha=-4.2", 0, 1e-3},
                                         {"universal", 0, 1e-3},
                                         {"cycloidal", 1, 1e-3},
                                         {"modified-sine", 2, 1e-4}}) {
    for (const Spread spread : kSpreads) {
      INFO(c.name << ", order " << c.order << ", spread " << static_cast<int>(spread));
      const Member law = find_law(c.name);
      const MotionSamples samples = sampled(law.law(), spread, c.noise, c.order);
      const LawFit fit = fit_law(samples, law, rough());
      CHECK(fit.fit.residuals.size() == samples.place.size());
      CHECK(fit.fit.degrees_of_freedom == static_cast<int>(samples.place.size() - fit.fit.rank));
      // The same again without stand-ins, from there.
      const LawResiduals all(samples, fit.law, fit.skew,
                             parameters_of(samples, fit.law, rough(), fit.skew));
      const auto values = values_of(fit.fit);
      const auto own = starting_at(all.own(), std::span(values).first(all.first()));
      const auto exact =
          all.told(optim::fit(own, all.residuals(), fit_options({}, optim::FitReach::Near)), 0.95);
      CHECK(fit.fit.sum_of_squares == Approx(exact.sum_of_squares).epsilon(1e-9));
      CHECK(fit.fit.sigma == Approx(exact.sigma).epsilon(1e-5));
      for (std::size_t j = 0; j < values.size(); ++j) {
        const double deviation = exact.parameters[j].standard_deviation;
        INFO(exact.parameters[j].name);
        if (!(deviation > 0) || !std::isfinite(deviation)) continue;
        CHECK(std::abs(values[j] - exact.parameters[j].value) < 0.003 * deviation);
        CHECK(fit.fit.parameters[j].standard_deviation == Approx(deviation).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("means are as narrow as little noise asks for", "[stand-ins]") {
  const Law<double> law = find_law("poly-3-4-5").law();
  const auto each = [&](Spread spread, double noise, std::size_t count) {
    const MotionSamples samples = sampled(law, spread, noise, 0, count);
    return condensed(samples.place, samples.value, 0, 100000).each;
  };
  CHECK(each(Spread::Even, 0.01, 19999) == 1);
  for (const Spread spread : {Spread::Even, Spread::Shuffled}) {
    CHECK(each(spread, 0.01, 30000) == 3);
    CHECK(each(spread, 2e-6, 30000) == 1);  // 1e-7 of the stroke
    CHECK(each(spread, 0.01, 200000) == 20);
    CHECK(each(spread, 1e-8, 200000) == 2);  // at most 100000 means
  }
  // A mean of so few lies beside the curve by less than a tenth of what its noise is.
  const MotionSamples samples = sampled(law, Spread::Even, 1e-4, 0, 100000);
  const Condensed means = condensed(samples.place, samples.value, 0, 100000);
  const double width = 150.0 * static_cast<double>(means.each) / 100000;
  const double bend = 20 * 5.7735 / (120 * 120) * width * width / 24;
  CHECK(bend < 0.1 * 1e-4 / std::sqrt(static_cast<double>(means.each)));
}

}  // namespace camlaw::problems::stand_ins_test
