// SPDX-License-Identifier: MIT
#include "numerics/scalar/root.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "numerics/scalar/dual.h"

namespace camlaw::root_test {

TEST_CASE("a root between two ends is found to the last places", "[root]") {
  CHECK(root_between([](double x) { return std::cos(x); }, 1, 2) ==
        Approx(std::acos(0.0)).epsilon(1e-14));
  CHECK(root_between([](double x) { return x * x * x - 2; }, 0, 100) ==
        Approx(std::cbrt(2.0)).epsilon(1e-14));
  // Flat on one side, where secants crawl.
  CHECK(root_between([](double x) { return std::pow(x, 21) - 1e-9; }, 0, 2) ==
        Approx(std::pow(10.0, -9.0 / 21)).epsilon(1e-12));
  CHECK(root_between([](double x) { return x; }, 0, 1) == Approx(0).margin(1e-15));
  CHECK(std::isnan(root_between([](double x) { return x * x + 1; }, 0, 1)));
  CHECK(std::isnan(root_between([](double) { return std::nan(""); }, 0, 1)));
}

TEST_CASE("a root carries two orders of derivatives", "[root]") {
  // x^3 = a at a = 2: x' = 1 / (3 x^2), x'' = -2 / (9 x^5).
  Dual2 a = number<Dual2>(2);
  a.v[0] = Dual(1.0);
  a.a.v[0] = 1;
  const double x = std::cbrt(2.0);
  const Dual2 root = root_near<Dual2>(
      x, [&](const Dual2& y) { return y * y * y - a; }, [](double y) { return 3 * y * y; });
  CHECK(root.a.a == Approx(x).epsilon(1e-15));
  CHECK(root.v[0].a == Approx(1 / (3 * x * x)).epsilon(1e-13));
  CHECK(root.v[0].v[0] == Approx(-2 / (9 * std::pow(x, 5))).epsilon(1e-13));
}

TEST_CASE("an interval holds the root, and is narrow", "[root]") {
  const auto f = [](const Interval& y) { return y * y - Interval(2.0); };
  const auto slope = [](const Interval& y) { return Interval(2.0) * y; };
  const Interval root = root_near<Interval>(std::sqrt(2.0), f, slope);
  const auto square_of = [](long double y) { return y * y; };
  CHECK((square_of(root.lower()) < 2 && square_of(root.upper()) > 2));
  CHECK(root.upper() - root.lower() < 1e-14);
  // Far from the root, and at a double root, nothing is claimed.
  CHECK(std::isnan(root_near<Interval>(1.0, f, slope).lower()));
  const auto square = [](const Interval& y) { return y * y; };
  CHECK(std::isnan(root_near<Interval>(0.0, square, slope).lower()));
}

}  // namespace camlaw::root_test
