// SPDX-License-Identifier: MIT
// Worn stretches of a measured lift.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "fitting/motions/recorded_motion.h"
#include "kinematics/laws/catalogue.h"
#include "tests/random_numbers.h"

namespace camlaw::problems::worn_lift_test {
namespace {

using Catch::Contains;
using testing::Random;

/// A rise from 30 to 120 deg by 12 mm, lower by up to `deep` from 60 to 110 deg; noise of 2 um.
MotionRecord rise(const Law<double>& law, double deep, unsigned seed) {
  Random random(seed);
  MotionRecord record;
  MotionSamples& samples = record.samples;
  samples.place_unit = "deg";
  samples.unit = samples.length_unit = "mm";
  for (int i = 0; i <= 150; ++i) {
    double s = 12 * law(std::clamp((i - 30) / 90.0, 0.0, 1.0)).s;
    if (i > 60 && i < 110) s -= deep * std::pow(std::sin(std::numbers::pi * (i - 60) / 50), 2);
    samples.place.push_back(i);
    samples.value.push_back(s + 0.002 * random.normal());
    record.lines.push_back(static_cast<std::uint32_t>(i + 2));
  }
  return record;
}

std::vector<Member> some_laws() {
  return {find_law("modified-sine"), find_law("cycloidal"), find_law("poly-3-4-5"),
          find_law("scca"), find_law("legendre")};
}

}  // namespace

TEST_CASE("a law that may have followed a worn stretch of a lift is not trusted", "[worn-lift]") {
  const RecordedMotion found =
      fit_recorded_motion(rise(find_law("modified-sine").law(), 0.03, 5), some_laws());
  REQUIRE(found.cycle.fits.size() == 1);
  const MotionFit& fit = found.cycle.fits[0];
  INFO(fit.best().law.label());
  CHECK_THAT(fit.distrust,
             Contains("worn stretch") && Contains("modified-sine") && Contains("mm lower from"));
}

TEST_CASE("a law with coefficients is trusted where nothing is worn", "[worn-lift]") {
  Member scca = find_law("scca");
  scca.arguments.values()[0] = {0.2}, scca.arguments.values()[1] = {0.1};
  scca.arguments.values()[2] = {0.7};
  for (const unsigned seed : {1U, 2U, 3U}) {
    const RecordedMotion found = fit_recorded_motion(rise(scca.law(), 0, seed), some_laws());
    REQUIRE(found.cycle.fits.size() == 1);
    INFO(found.cycle.fits[0].best().law.label());
    CHECK_THAT(found.cycle.fits[0].distrust, !Contains("worn"));
  }
}

}  // namespace camlaw::problems::worn_lift_test
