// SPDX-License-Identifier: MIT
// Laws fitted in several processes: the same ranking to the last bit.
#include <unistd.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <random>

#include "fitting/constants/constants_fit.h"
#include "fitting/motions/law_fit_service.h"
#include "fitting/motions/law_ranking.h"
#include "optim/problem/deadline.h"
#include "problems/statement/law_names.h"

namespace camlaw::problems::law_fits_side_by_side_test {
namespace {

MotionSamples noisy(std::size_t count) {
  MotionSamples samples;
  samples.place_unit = "deg";
  samples.unit = "mm";
  const Law<double> law = find_law("modified-sine").law();
  std::mt19937_64 random(3);
  std::normal_distribution<> normal;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = 150.0 * static_cast<double>(i) / static_cast<double>(count);
    const double u = std::clamp((place - 10) / 120, 0.0, 1.0);
    samples.place.push_back(place);
    samples.value.push_back(3 + 20 * law.derivatives<1>(u, Side::Right)[0] + 0.01 * normal(random));
  }
  return samples;
}

MotionGuess rough() { return {4, 138, 2.5, 23.9}; }

std::string bits(double value) { return std::to_string(std::bit_cast<std::uint64_t>(value)) + " "; }

std::string bits(const Ranking& ranking) {
  std::string text;
  for (const LawFit& fit : ranking.fits) {
    text += fit.law.name() + " " + bits(fit.criterion) + bits(fit.weight) + bits(fit.begin) +
            bits(fit.end) + bits(fit.from) + bits(fit.to) + std::to_string(fit.numbers) + " " +
            fit.fit.reason;
    for (const optim::FittedParameter& p : fit.fit.parameters) {
      text += p.name + bits(p.value) + bits(p.standard_deviation) + bits(p.low) + bits(p.high);
    }
    for (const double r : fit.fit.residuals) text += bits(r);
    for (std::size_t i = 0; i < fit.fit.covariance.size(); ++i) {
      text += bits(fit.fit.covariance(i, 0));
    }
    for (const double i : fit.inflation) text += bits(i);
    text += "\n";
  }
  for (const std::string& name : ranking.untried) text += name + " untried\n";
  return text;
}

/// Processes from the first fit on, however short it is.
optim::Crew crew_of(int workers) { return optim::Crew({.workers = workers, .at_once = true}); }

}  // namespace

TEST_CASE("laws fitted in several processes are ranked alike", "[fit][workers]") {
  const MotionSamples samples = noisy(200);
  for (const optim::Loss loss : {optim::Loss::None, optim::Loss::Huber}) {
    LawFitOptions options;
    options.loss = loss;
    const std::string expected = bits(rank_fits(samples, laws_to_try(), rough(), options));
    for (const int workers : {1, 2, 3}) {
      INFO(workers);
      optim::Crew crew = crew_of(workers);
      options.crew = &crew;
      CHECK(bits(rank_fits(samples, laws_to_try(), rough(), options)) == expected);
    }
  }
}

TEST_CASE("a law that is not the catalogue's is fitted in a copy of this process",
          "[fit][workers]") {
  Family own = *find_law("poly-3-4-5").family;
  own.name = "own";
  const std::vector<Member> laws{{std::make_shared<const Family>(own), own.defaults()},
                                 find_law("cycloidal")};
  CHECK_FALSE(is_of_catalogue(laws[0]));
  CHECK(is_of_catalogue(laws[1]));
  const std::string expected = bits(rank_fits(noisy(100), laws, rough()));
  optim::Crew crew = crew_of(2);
  LawFitOptions options;
  options.crew = &crew;
  CHECK(bits(rank_fits(noisy(100), laws, rough(), options)) == expected);
}

TEST_CASE("a process that dies in a fit is an error, and no law is left out in silence",
          "[fit][workers]") {
  const pid_t parent = getpid();
  Family own = *find_law("poly-3-4-5").family;
  own.name = "deadly";
  own.maker = Maker([parent, maker = own.maker](const auto& arguments) {
    if (getpid() != parent) raise(SIGKILL);
    return maker.make(arguments);
  });
  const std::vector<Member> laws{find_law("cycloidal"),
                                 {std::make_shared<const Family>(own), own.defaults()}};
  optim::Crew crew = crew_of(2);
  LawFitOptions options;
  options.crew = &crew;
  CHECK_THROWS_WITH(rank_fits(noisy(100), laws, rough(), options),
                    Catch::Contains("killed by signal 9"));
}

TEST_CASE("fits in several processes are not tried after the deadline, and end on a stop",
          "[fit][workers]") {
  optim::Crew crew = crew_of(2);
  LawFitOptions options;
  options.crew = &crew;
  options.deadline = LawFitOptions::Clock::now();
  const Ranking late = rank_fits(noisy(100), laws_to_try(), rough(), options);
  CHECK(late.fits.size() >= 1);
  CHECK_FALSE(late.untried.empty());
  const std::atomic<bool> stop = true;
  options.stop = &stop;
  CHECK_THROWS_AS(rank_fits(noisy(100), laws_to_try(), rough(), options), optim::Interrupted);
}

TEST_CASE("what is no fit is refused", "[fit][workers]") {
  CHECK_THROWS_AS(law_fit_answer("nonsense", find_law("cycloidal")), std::runtime_error);
  CHECK_THROWS_AS(law_fit_answer("", find_law("cycloidal")), std::runtime_error);
  CHECK(law_fit_service({})("nonsense", {}) == "");
}

}  // namespace camlaw::problems::law_fits_side_by_side_test
