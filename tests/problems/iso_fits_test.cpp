// SPDX-License-Identifier: MIT
#include "problems/statement/iso_fits.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "tests/problems/complaint.h"

// Fits against limits that are printed elsewhere than the tables they are kept in, and against the
// standard's formulae.
namespace camlaw::problems::iso_fits_test {
namespace {

void check(const char* fit, double size, double lower, double upper) {
  const FitDeviations found = fit_deviations(parse_fit(fit), size);
  INFO(fit << " of " << size << " mm");
  CHECK(1000 * found.lower == Approx(lower).margin(1e-9));
  CHECK(1000 * found.upper == Approx(upper).margin(1e-9));
}

}  // namespace

TEST_CASE("Fits have the limits that tables of shafts and holes print", "[variation]") {
  // JIS B 0401 (1999), shafts, as printed by a maker of tools.
  check("f7", 20, -41, -20);
  check("g6", 45, -25, -9);
  check("h7", 100, -35, 0);
  check("js6", 25, -6.5, 6.5);
  check("k6", 8, 1, 10);
  check("k5", 60, 2, 15);
  check("m6", 30, 8, 21);
  check("n6", 3, 4, 10);
  check("p6", 40, 26, 42);
  check("e9", 70, -134, -60);
  check("d9", 9, -76, -40);
  // Running fits of shafts, and holes E and D, of an ISO table of limits of size.
  check("d11", 450, -630, -230);
  check("e7", 200, -146, -100);
  check("E9", 5, 20, 50);
  check("D10", 12, 50, 120);
  check("H7", 50, 0, 25);
  check("G7", 50, 9, 34);
  check("JS8", 50, -19.5, 19.5);
  check("k8", 50, 0, 39);
}

TEST_CASE("Scales at the end of a step belong to it", "[variation]") {
  check("h7", 3, -10, 0);
  check("h7", 3.0001, -12, 0);
  check("h7", 500, -63, 0);
  CHECK_THROWS_AS(fit_deviations(parse_fit("h7"), 501), std::invalid_argument);
  CHECK_THROWS_AS(fit_deviations(parse_fit("h7"), 0), std::invalid_argument);
}

TEST_CASE("Standard tolerances are those of the formula, rounded", "[variation]") {
  const double ends[] = {1, 3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};
  const double times[] = {7, 10, 16, 25, 40, 64, 100};
  for (int grade = 5; grade <= 11; ++grade) {
    for (int step = 1; step < 13; ++step) {  // the first is rounded otherwise
      const double middle = std::sqrt(ends[step] * ends[step + 1]);
      const double i = 0.45 * std::cbrt(middle) + 0.001 * middle;
      const double formula = times[grade - 5] * i, kept = 1000 * standard_tolerance(grade, middle);
      INFO("IT" << grade << " at " << middle << " mm: " << kept << ", formula " << formula);
      CHECK(std::abs(kept - formula) <= std::max(1.0, 0.04 * formula));
    }
  }
}

TEST_CASE("Deviations are those of their formulae, rounded", "[variation]") {
  const double ends[] = {3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};
  for (int step = 0; step < 12; ++step) {
    const double middle = std::sqrt(ends[step] * ends[step + 1]);
    const auto nearest = [&](const char* fit, bool upper) {
      const FitDeviations off = fit_deviations(parse_fit(fit), middle);
      return 1000 * (upper ? off.upper : off.lower);
    };
    INFO(middle << " mm");
    CHECK(nearest("d8", true) == Approx(-16 * std::pow(middle, 0.44)).epsilon(0.03));
    CHECK(nearest("e8", true) == Approx(-11 * std::pow(middle, 0.41)).epsilon(0.03));
    CHECK(nearest("f7", true) == Approx(-5.5 * std::pow(middle, 0.41)).epsilon(0.03));
    CHECK(std::abs(nearest("g6", true) + 2.5 * std::pow(middle, 0.34)) <= 1);
    CHECK(std::abs(nearest("k6", false) - 0.6 * std::cbrt(middle)) <= 0.8);
    CHECK(std::abs(nearest("n6", false) - 5 * std::pow(middle, 0.34)) <= 1);
    const double m = 1000 * (standard_tolerance(7, middle) - standard_tolerance(6, middle));
    CHECK(std::abs(nearest("m6", false) - m) <= 1);
    const double p = nearest("p6", false) - 1000 * standard_tolerance(7, middle);
    CHECK((p >= 0 && p <= 5));
  }
}

TEST_CASE("What is not a fit is refused", "[variation]") {
  using Catch::Contains;
  for (const char* text : {"", "h", "7", "h4", "h12", "q7", "K7", "h07", "js", "7h", "h7 "}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_fit(text), Contains("is not a known fit") && Contains("h7"));
  }
}

}  // namespace camlaw::problems::iso_fits_test
