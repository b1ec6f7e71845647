// SPDX-License-Identifier: MIT
// Every family of laws from its own samples: coefficients come back, and intervals hold as often as
// they say.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include "fitting/constants/constants_fit.h"
#include "fitting/motions/law_fit.h"

namespace camlaw::problems::law_coverage_test {
namespace {

constexpr double kBegin = 10, kEnd = 130, kStroke = 20, kZero = 3;

/// A member of each family, away from where fits start and from where phases vanish.
Member truth_of(const Member& start) {
  static const std::map<std::string, std::string> kMembers{
      {"polynomial-5", "alpha=-4.2"},
      {"polynomial-7", "A=31"},
      {"legendre", "c=-1.2,0.4"},
      {"boundary-5", "v0=0.4 a0=3 v1=0.3 a1=-2"},
      {"boundary-7", "v0=0.4 a0=3 j0=20 v1=0.3 a1=-2 j1=10"},
      {"fourier", "a=0.05,0.02"},
      {"trapezoidal-velocity", "t1=0.3 t2=0.4"},
      {"trapezoidal-acceleration", "ramp=0.1 constant=0.2"},
      {"s-curve", "B=1.7 C=5.5"},
      {"scca", "a=0.25 b=0.3 c=0.3"},
      {"universal", "d1=0.12 d2=0.12 d3=0.12 d4=0.08 d5=0.18 d6=0.18"},
      {"elliptic", "n=1.7"},
      {"inclined-sinusoid", "angle=80"}};
  Member truth = start;
  const std::string& name = start.family->name;
  if (name == "triple-harmonic") {  // h1 / (2 pi) + h2 / (4 pi) + h3 / (6 pi) = 1
    const double h1 = 6, h2 = 0.4;
    const double h3 = 6 * std::numbers::pi - 3 * h1 - 1.5 * h2;
    truth.arguments.values()[0] = {h1};
    truth.arguments.values()[1] = {h2};
    truth.arguments.values()[2] = {h3};
    return truth;
  }
  const auto found = kMembers.find(name);
  return found == kMembers.end() ? start : find_law(name + " " + found->second);
}

MotionSamples sampled(const Law<double>& law, std::size_t count, double noise, std::uint64_t seed) {
  MotionSamples samples;
  samples.place_unit = "deg";
  samples.unit = "mm";
  std::mt19937_64 random(seed);
  std::normal_distribution<> normal;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = 150.0 * (static_cast<double>(i) + 0.37) / static_cast<double>(count);
    const double u = std::clamp((place - kBegin) / (kEnd - kBegin), 0.0, 1.0);
    samples.place.push_back(place);
    samples.value.push_back(kZero + kStroke * (law(u).s + noise * normal(random)));
  }
  return samples;
}

MotionGuess rough() { return {4, 138, 2.5, 23.9}; }

/// With free velocities and accelerations at its ends a polynomial is the same curve over any
/// stretch: begin and end are determined by nothing but how it meets the dwells.
bool has_free_ends(const Member& law) { return law.family->name.rfind("boundary-", 0) == 0; }

/// Begin, end, stroke, zero and the coefficients, in the order of a fit.
std::vector<double> numbers_of(const Member& law) {
  std::vector<double> numbers{kBegin, kEnd, kStroke, kZero};
  const auto& parameters = law.family->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].structural || parameters[i].name == kCrossover) continue;
    for (const double value : law.arguments.list(i)) numbers.push_back(value);
  }
  return numbers;
}

/// How many of the intervals that a fit vouches for hold the truth.
struct Count {
  int fits = 0, trusted = 0, intervals = 0, held = 0;
  double rate() const { return static_cast<double>(held) / intervals; }
  void add(const LawFit& fit, const std::vector<double>& truth) {
    ++fits;
    if (!fit.fit.reason.empty()) return;
    ++trusted;
    for (std::size_t j = 0; j < truth.size(); ++j) {
      const auto& p = fit.fit.parameters[j];
      if (p.low == p.high) continue;  // given, such as a law's own end values
      ++intervals;
      held += p.low <= truth[j] && truth[j] <= p.high;
    }
  }
  void add(const Count& other) {
    fits += other.fits, trusted += other.trusted;
    intervals += other.intervals, held += other.held;
  }
};

}  // namespace

TEST_CASE("every family comes back from samples without noise", "[law-fit][heavy]") {
  for (const Member& start : laws_to_try()) {
    const Member law = truth_of(start);
    const std::vector<double> truth = numbers_of(law);
    for (const std::size_t count : {50, 200, 2000}) {
      INFO(law.name() << ", " << count << " samples");
      const LawFit fit = fit_law(sampled(law.law(), count, 0, 1), start, rough());
      CHECK(fit.fit.converged);
      CHECK(fit.fit.rms < 1e-7 * kStroke);
      for (std::size_t j = 0; j < truth.size(); ++j) {
        const auto& p = fit.fit.parameters[j];
        INFO(p.name);
        CHECK(p.identifiable);
        CHECK(p.value == Approx(truth[j]).epsilon(1e-6).margin(1e-6));
      }
    }
  }
}

TEST_CASE("intervals of every family hold as often as they say", "[law-fit][heavy]") {
  struct Size {
    std::size_t count;
    unsigned runs;
  };
  Count all;
  std::uint64_t seed = 1;
  for (const Member& start : laws_to_try()) {
    if (has_free_ends(start)) continue;
    const Member law = truth_of(start);
    const std::vector<double> truth = numbers_of(law);
    Count family;
    for (const double noise : {1e-3, 1e-2}) {
      for (const Size& size : {Size{50, 8}, Size{200, 5}, Size{2000, 1}}) {
        for (unsigned run = 0; run < size.runs; ++run) {
          const auto samples = sampled(law.law(), size.count, noise, ++seed);
          family.add(fit_law(samples, start, rough()), truth);
        }
      }
    }
    INFO(law.name() << ": " << family.held << " of " << family.intervals << " intervals, "
                    << family.trusted << " of " << family.fits << " fits trusted");
    // Those of one fit go together, so chance is that of as many fits: four deviations.
    const double chance = std::sqrt(0.95 * 0.05 / std::max(1, family.trusted));
    CHECK(family.trusted > family.fits / 4);
    CHECK(family.rate() > 0.95 - 4 * chance);
    all.add(family);
  }
  INFO(all.held << " of " << all.intervals << " intervals, " << all.trusted << " of " << all.fits
                << " fits trusted");
  CHECK(all.rate() > 0.92);
  CHECK(all.rate() < 0.975);
  CHECK(all.trusted > all.fits * 8 / 10);
}

}  // namespace camlaw::problems::law_coverage_test
