// SPDX-License-Identifier: MIT
#include "numerics/scalar/series.h"

#include <boost/math/special_functions/binomial.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace camlaw::series_test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;
constexpr std::size_t kOrder = 12;
template <class T>
using S = Series<T, kOrder>;

/// Checks a coefficient against its closed form: near for double, held for Interval.
void check(double c, const Exact& exact) {
  CHECK(std::abs(c - exact.convert_to<double>()) <= 1e-13 * (1 + std::abs(c)));
}
void check(const Interval& c, const Exact& exact) {
  CHECK(Exact(c.lower()) <= exact);
  CHECK(exact <= Exact(c.upper()));
  CHECK(boost::numeric::width(c) <= 1e-11 * (1 + magnitude(c)));
}

Exact factorial(std::size_t k) { return k == 0 ? Exact(1) : Exact(k) * factorial(k - 1); }

S<double> random_series(std::mt19937_64& random) {
  std::uniform_real_distribution<double> value(-1, 1);
  S<double> f;
  for (double& c : f.c) c = value(random);
  f.c[0] = 1.5 + value(random);  // away from 0, so that it can divide
  return f;
}

TEMPLATE_TEST_CASE("The quotient 1 / (1 - x) is the geometric series", "[series]", double,
                   Interval) {
  const double at = GENERATE(0.0, 0.25, -2.0);
  const auto one = S<TestType>(number<TestType>(1));
  const auto x = S<TestType>::variable(number<TestType>(at), number<TestType>(1));
  const auto f = one / (one - x);
  for (std::size_t k = 0; k < kOrder; ++k) {
    CAPTURE(at, k);
    check(f.c[k], 1 / pow(1 - Exact(at), static_cast<int>(k) + 1));
  }
}

TEMPLATE_TEST_CASE("The square root of 1 + x is the binomial series", "[series]", double,
                   Interval) {
  const double at = GENERATE(0.0, 0.5, -0.75);
  const auto one = S<TestType>(number<TestType>(1));
  const auto f = sqrt(one + S<TestType>::variable(number<TestType>(at), number<TestType>(1)));
  Exact binomial = 1;  // (1/2 over k)
  for (std::size_t k = 0; k < kOrder; ++k) {
    CAPTURE(at, k);
    check(f.c[k], binomial * pow(1 + Exact(at), Exact(0.5) - k));
    binomial *= (Exact(0.5) - k) / (k + 1);
  }
}

TEMPLATE_TEST_CASE("sincos gives the Taylor series of sine and cosine", "[series]", double,
                   Interval) {
  const double at = GENERATE(0.0, 0.7, -2.5);
  const double rate = 1.5;
  const auto [sine, cosine] =
      sincos(S<TestType>::variable(number<TestType>(at), number<TestType>(rate)));
  const Exact quarter = boost::math::constants::half_pi<Exact>();
  for (std::size_t k = 0; k < kOrder; ++k) {
    CAPTURE(at, k);
    const Exact scale = pow(Exact(rate), static_cast<int>(k)) / factorial(k);
    check(sine.c[k], sin(at + k * quarter) * scale);
    check(cosine.c[k], cos(at + k * quarter) * scale);
  }
}

TEMPLATE_TEST_CASE("A product of binomials is the binomial of the sum", "[series]", double,
                   Interval) {
  const auto one = S<TestType>(number<TestType>(1));
  const auto base = one + S<TestType>::variable(number<TestType>(0), number<TestType>(1));
  auto third = base, fourth = base;
  for (int i = 0; i < 3; ++i) third = i < 2 ? third * base : third, fourth = fourth * base;
  const auto seventh = third * fourth;
  for (unsigned k = 0; k < kOrder; ++k) {
    CAPTURE(k);
    check(seventh.c[k], k <= 7 ? Exact(boost::math::binomial_coefficient<double>(7, k)) : Exact(0));
  }
}

TEST_CASE("sine and cosine of any series have squares that add up to 1", "[series]") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20; ++i) {
    const auto [sine, cosine] = sincos(random_series(random));
    const auto one = sine * sine + cosine * cosine;
    CHECK(std::abs(one.c[0] - 1) <= 1e-13);
    for (std::size_t k = 1; k < kOrder; ++k) CHECK(std::abs(one.c[k]) <= 1e-12);
  }
}

TEST_CASE("Quotients and square roots of random series multiply back", "[series]") {
  std::mt19937_64 random(11);
  for (int i = 0; i < 50; ++i) {
    const auto f = random_series(random), g = random_series(random);
    const auto quotient = f / g;
    const auto root = sqrt(f);
    const auto back = quotient * g, square = root * root;
    double size = 1;
    for (const double c : quotient.c) size = std::max(size, std::abs(c));
    for (const double c : root.c) size = std::max(size, c * c);
    for (std::size_t k = 0; k < kOrder; ++k) {
      CHECK(std::abs(back.c[k] - f.c[k]) <= 1e-13 * size);
      CHECK(std::abs(square.c[k] - f.c[k]) <= 1e-13 * size);
    }
  }
}

TEST_CASE("Sums, differences and multiples act on every coefficient", "[series]") {
  std::mt19937_64 random(13);
  const auto f = random_series(random), g = random_series(random);
  const auto sum = f + g, difference = f - g, twice = 2.0 * f;
  for (std::size_t k = 0; k < kOrder; ++k) {
    CHECK(sum.c[k] == f.c[k] + g.c[k]);
    CHECK(difference.c[k] == f.c[k] - g.c[k]);
    CHECK(twice.c[k] == 2 * f.c[k]);
  }
}

TEMPLATE_TEST_CASE("The derivative of the integral is the series without its last term", "[series]",
                   double, Interval) {
  S<TestType> f;
  for (std::size_t k = 0; k < kOrder; ++k)
    f.c[k] = ratio<TestType>(1, 3.0 + static_cast<double>(k));
  const auto primitive = integral(f, number<TestType>(5));
  CHECK(is_number(primitive.c[0], 5));
  const Series<TestType, kOrder - 1> back = derivative(primitive);
  for (std::size_t k = 0; k + 1 < kOrder; ++k) check(back.c[k], Exact(1) / (3 + k));
}

TEST_CASE("derivatives are the coefficients times factorials", "[series]") {
  // f = 1 / (1 - x) at 0 has f^(k) = k!, so k! c[k] with c[k] = 1.
  S<double> f;
  f.c.fill(1);
  const auto d = derivatives(f);
  for (std::size_t k = 0; k < kOrder; ++k) CHECK(d[k] == factorial(k).convert_to<double>());
}

TEST_CASE("The root of a vanishing series has infinite derivatives of the limit's sign",
          "[series]") {
  // sqrt(h): the derivatives alternate from +inf on; sqrt(-h): all are -inf.
  const auto rising = sqrt(S<double>::variable(0, 1));
  const auto falling = sqrt(S<double>::variable(0, -1));
  CHECK(rising.c[0] == 0);
  for (std::size_t k = 1; k < kOrder; ++k) {
    CAPTURE(k);
    CHECK(std::isinf(rising.c[k]));
    CHECK(std::signbit(rising.c[k]) == (k % 2 == 0));
    CHECK(falling.c[k] == -std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("A series over a box holds the series of every point in it", "[series]") {
  const Interval box(0.2, 0.4);
  const auto one = S<Interval>(Interval(1.0));
  const auto x = S<Interval>::variable(box, Interval(1.0));
  const auto f = one / sqrt(one - x * x);
  for (const double at : {0.2, 0.27, 0.33, 0.4}) {
    const auto unit = S<double>(1);
    const auto point = S<double>::variable(at, 1);
    const auto exact = unit / sqrt(unit - point * point);
    for (std::size_t k = 0; k < kOrder; ++k) {
      CAPTURE(at, k);
      CHECK(boost::numeric::in(exact.c[k], f.c[k]));
    }
  }
}

}  // namespace
}  // namespace camlaw::series_test
