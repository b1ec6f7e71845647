// SPDX-License-Identifier: MIT
#include "optim/tables/printed_number.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace camlaw::optim::printed_number_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST_CASE("a print agrees with everything that rounds to it and with nothing else") {
  CHECK(agrees({8.91, 2}, 8.914));
  CHECK(agrees({8.91, 2}, 8.906));
  CHECK_FALSE(agrees({8.91, 2}, 8.9151));
  CHECK_FALSE(agrees({8.91, 2}, 8.9049));
  CHECK(agrees({14.0, 0}, std::sqrt(196.0)));
  CHECK(agrees({50.0, 0}, 49.6));
  CHECK_FALSE(agrees({50.0, 0}, 50.6));
  CHECK(agrees({-1.5, 1}, -1.54));
  CHECK_FALSE(agrees({-1.5, 1}, 1.5));
  CHECK(agrees({0.0, 2}, -0.004));
}

TEST_CASE("an exact half may be rounded either way") {
  CHECK(agrees({18.74, 2}, 18.745));
  CHECK(agrees({18.75, 2}, 18.745));
  CHECK(agrees({1.87, 2}, 1.875));
  CHECK(agrees({1.88, 2}, 1.875));
  CHECK(agrees({-2.0, 0}, -2.5));
  CHECK(agrees({-3.0, 0}, -2.5));
  CHECK(agrees({1234567.89, 2}, 1234567.885));
  CHECK(agrees({1234567.88, 2}, 1234567.885));
  CHECK_FALSE(agrees({1.87, 2}, 1.875 + 1e-9));
}

TEST_CASE("what is not finite never agrees and is never a misprint") {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    CHECK_FALSE(agrees({1.0, 2}, bad));
    CHECK_FALSE(agrees({bad, 2}, 1.0));
    CHECK_FALSE(agrees({bad, 2}, bad));
    CHECK_FALSE(one_digit_misprint({1.0, 2}, bad));
    CHECK_FALSE(one_digit_misprint({bad, 2}, 1.0));
  }
}

TEST_CASE("a value is printed with its decimals and without a negative zero") {
  CHECK(as_printed(59.967, 2) == "59.97");
  CHECK(as_printed(49.6, 0) == "50");
  CHECK(as_printed(-1.25, 1) == "-1.2");
  CHECK(as_printed(-0.001, 2) == "0.00");
  CHECK(as_printed(-0.2, 0) == "0");
  CHECK(as_printed(1.0, 3) == "1.000");
  CHECK(as_printed(kNan, 2) == "nan");
}

TEST_CASE("a misprint is one wrong digit") {
  CHECK(one_digit_misprint({58.97, 2}, 59.97));
  CHECK(one_digit_misprint({58.97, 2}, 59.9679));
  CHECK(one_digit_misprint({1.533, 3}, 1.553));
  CHECK(one_digit_misprint({-1.533, 3}, -1.553));
  CHECK(one_digit_misprint({14.0, 0}, 19.2));
  CHECK(one_digit_misprint({0.40, 2}, 0.50));
  CHECK(one_digit_misprint({0.14, 2}, 0.04));
  CHECK_FALSE(one_digit_misprint({34.55, 2}, 34.64));
  CHECK_FALSE(one_digit_misprint({58.97, 2}, 58.97));
  CHECK_FALSE(one_digit_misprint({58.97, 2}, 58.9749));
}

TEST_CASE("a misprint keeps the sign and the number of digits") {
  CHECK_FALSE(one_digit_misprint({9.9, 1}, 10.9));
  CHECK_FALSE(one_digit_misprint({99.0, 0}, 199.0));
  CHECK_FALSE(one_digit_misprint({1.53, 2}, -1.53));
  CHECK_FALSE(one_digit_misprint({1.53, 2}, -1.55));
  CHECK(one_digit_misprint({0.99, 2}, 1.99));
}

TEST_CASE("a misprint needs another significant digit that vouches for it") {
  CHECK_FALSE(one_digit_misprint({5.0, 0}, 7.0));
  CHECK_FALSE(one_digit_misprint({0.04, 2}, 0.05));
  CHECK_FALSE(one_digit_misprint({0.04, 2}, 0.0));
  CHECK(one_digit_misprint({50.0, 0}, 70.0));
}

TEST_CASE("an exact half can be a misprint of either rounding") {
  CHECK(one_digit_misprint({2.13, 2}, 1.125));
  CHECK(one_digit_misprint({2.12, 2}, 1.125));
  CHECK(one_digit_misprint({-2.13, 2}, -1.125));
  CHECK(one_digit_misprint({-2.12, 2}, -1.125));
  CHECK_FALSE(one_digit_misprint({2.14, 2}, 1.125));
}

TEST_CASE("numbers beyond the precision of a double are not misprints") {
  CHECK_FALSE(one_digit_misprint({1e300, 2}, 2e300));
  CHECK_FALSE(one_digit_misprint({1.0, 2}, 1e300));
}

/// Independent of the library's arithmetic: compares the printed characters.
bool differs_in_one_character(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  int differing = 0;
  int vouching = 0;
  const std::size_t first = std::min(a.find_first_of("123456789"), b.find_first_of("123456789"));
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == '.') continue;
    if (a[i] != b[i])
      ++differing;
    else if (i >= first)
      ++vouching;
  }
  return differing == 1 && vouching > 0;
}

TEST_CASE("the digit arithmetic agrees with a comparison of the printed characters") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> decimals(0, 3);
  std::uniform_int_distribution<int> units(0, 1999);
  int misprints = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const int d = decimals(random);
    const double scale = std::pow(10.0, d);
    const double print = units(random) / scale;
    const double ours = (units(random) + 0.3) / scale;
    const bool expected = differs_in_one_character(as_printed(print, d), as_printed(ours, d));
    misprints += expected;
    CAPTURE(print, ours, d);
    REQUIRE(one_digit_misprint({print, d}, ours) == expected);
  }
  CHECK(misprints > 100);
}

}  // namespace
}  // namespace camlaw::optim::printed_number_test
