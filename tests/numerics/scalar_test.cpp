// SPDX-License-Identifier: MIT
#include "numerics/scalar/scalar.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <type_traits>

#include "numerics/scalar/dual.h"

namespace camlaw::scalar_test {
namespace {

/// The variable number k of a Hessian: value, gradient e_k, second derivatives 0.
Dual2 second_order(double value, int k) { return Dual2(Dual(value, k), k); }

TEMPLATE_TEST_CASE("Constants of every scalar are the plain number", "[scalar]", double, Dual,
                   Dual2, Interval) {
  const auto x = number<TestType>(-2.5);
  CHECK(value_of(x) == -2.5);
  CHECK(is_number(x, -2.5));
  CHECK_FALSE(is_number(x, 2.5));
  CHECK(is_number(number<TestType>(0), 0));
  CHECK(value_of(ratio<TestType>(3, 4)) == 0.75);
  CHECK(value_of(ratio<TestType>(1, 3)) == Approx(1.0 / 3.0).epsilon(1e-15));
  CHECK(value_of(pi<TestType>()) == Approx(std::numbers::pi).epsilon(1e-15));
  CHECK(value_of(convert<TestType>(0.7)) == 0.7);
  CHECK(convert<double>(x) == -2.5);
  CHECK(is_number(convert<TestType>(x), -2.5));
  CHECK(is_number(integer_power(x, 0), 1));
  CHECK(value_of(integer_power(x, 3)) == -15.625);
  STATIC_REQUIRE(std::is_same_v<Joined<double, TestType>, TestType>);
  STATIC_REQUIRE(std::is_same_v<Joined<TestType, double>, TestType>);
}

TEST_CASE("A dual with a derivative part is not a constant", "[scalar]") {
  CHECK_FALSE(is_number(Dual(1.0, 2), 1));
  CHECK_FALSE(is_number(second_order(1, 3), 1));
  Dual2 curved(number<Dual2>(1));
  curved.v[1].v[2] = 1e-300;  // only a second derivative
  CHECK_FALSE(is_number(curved, 1));
  Dual2 inner(number<Dual2>(1));
  inner.a.v[0] = 1;
  CHECK_FALSE(is_number(inner, 1));
}

TEST_CASE("An interval with width is not a constant, and its value is the middle", "[scalar]") {
  CHECK_FALSE(is_number(Interval(1, step_up(1)), 1));
  CHECK(value_of(Interval(1, 3)) == 2);
  CHECK(convert<double>(Interval(-1, 4)) == 1.5);
}

TEST_CASE("A ratio of intervals encloses the fraction", "[scalar]") {
  for (int q = 1; q <= 60; ++q) {
    for (int p = -7; p <= 7; ++p) {
      const auto third = ratio<Interval>(p, q);
      CAPTURE(p, q);
      // Exact: lower q <= p <= upper q with one rounding by fma.
      CHECK(std::fma(third.lower(), q, -p) <= 0);
      CHECK(std::fma(third.upper(), q, -p) >= 0);
    }
  }
}

TEST_CASE("real_power of a double is pow", "[scalar]") {
  CHECK(real_power(4.0, 0.5) == 2);
  CHECK(real_power(0.0, 2.5) == 0);
  CHECK(real_power(3.0, 0) == 1);
}

TEST_CASE("real_power of a Dual has the derivative p x^(p-1)", "[scalar]") {
  for (const double p : {2.0, 2.5, 3.7, 0.5, -1.5}) {
    for (const double x : {0.2, 1.0, 3.5}) {
      Dual variable(x, 1);
      variable.v[3] = -2;  // a second direction, by the chain rule
      const Dual y = real_power(variable, p);
      const double slope = p * std::pow(x, p) / x;
      CAPTURE(p, x);
      CHECK(y.a == std::pow(x, p));
      CHECK(y.v[0] == 0);
      CHECK(y.v[1] == Approx(slope).epsilon(1e-14));
      CHECK(y.v[3] == Approx(-2 * slope).epsilon(1e-14));
    }
  }
}

TEST_CASE("real_power of a Dual2 has the second derivative p (p-1) x^(p-2)", "[scalar]") {
  for (const double p : {2.5, 4.0, -0.5}) {
    const double x = 0.8, y = 1.7;
    // f = (x y)^p: f_xx = p (p-1) y^2 (x y)^(p-2), f_xy = p^2 (x y)^(p-1).
    const Dual2 f = real_power(second_order(x, 0) * second_order(y, 1), p);
    const double z = x * y;
    CAPTURE(p);
    CHECK(f.a.a == Approx(std::pow(z, p)).epsilon(1e-14));
    CHECK(f.v[0].a == Approx(p * y * std::pow(z, p - 1)).epsilon(1e-14));
    CHECK(f.a.v[1] == Approx(p * x * std::pow(z, p - 1)).epsilon(1e-14));
    CHECK(f.v[0].v[0] == Approx(p * (p - 1) * y * y * std::pow(z, p - 2)).epsilon(1e-13));
    CHECK(f.v[0].v[1] == Approx(p * p * std::pow(z, p - 1)).epsilon(1e-13));
    CHECK(f.v[1].v[0] == Approx(f.v[0].v[1]).epsilon(1e-14));
  }
}

TEST_CASE("x^0 is 1 with derivative 0 at x = 0 too", "[scalar]") {
  const Dual one = real_power(Dual(0.0, 0), 0);
  CHECK(one.a == 1);
  CHECK(one.v[0] == 0);
}

}  // namespace
}  // namespace camlaw::scalar_test
