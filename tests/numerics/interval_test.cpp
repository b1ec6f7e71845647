// SPDX-License-Identifier: MIT
#include "numerics/scalar/interval.h"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "numerics/scalar/scalar.h"

namespace camlaw::interval_test {
namespace {

/// 50 digits and a wide exponent: sums, products and quotients of doubles are exact in it or
/// rounded far below the last bit of a double.
using Exact = boost::multiprecision::cpp_bin_float_50;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

bool holds(const Interval& box, const Exact& x) {
  return Exact(box.lower()) <= x && x <= Exact(box.upper());
}

/// Boxes with points inside, of any sign and with exponents up to `range`.
struct Boxes {
  std::mt19937_64 random{20240611};
  int range;

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  double any() {
    const int exponent = std::uniform_int_distribution<int>(-range, range)(random);
    return std::ldexp(between(-2, 2), exponent);
  }
  Interval box() {
    const double a = any();
    const double b = between(0, 1) < 0.5 ? any() : a * (1 + between(0, 1e-10));
    return {std::min(a, b), std::max(a, b)};
  }
  double inside(const Interval& box) {
    const double choice = between(0, 4);
    if (choice < 1) return box.lower();
    if (choice < 2) return box.upper();
    return std::clamp(std::lerp(box.lower(), box.upper(), between(0, 1)), box.lower(), box.upper());
  }
};

TEST_CASE("step_up and step_down go to the neighbouring double everywhere", "[interval]") {
  for (const double x : {0.0, -0.0, kTiny, -kTiny, std::numeric_limits<double>::min(), 1.0, -1.0,
                         kMax, -kMax, 0.1, -1e300, 3 * kTiny}) {
    CAPTURE(x);
    CHECK(step_up(x) == std::nextafter(x, kInfinity));
    CHECK(step_down(x) == std::nextafter(x, -kInfinity));
  }
  CHECK(step_up(kInfinity) == kInfinity);
  CHECK(step_down(-kInfinity) == -kInfinity);
  CHECK(step_up(-kInfinity) == -kMax);
  CHECK(step_down(kInfinity) == kMax);
  CHECK(std::isnan(step_up(kNan)));
  CHECK(std::isnan(step_down(kNan)));
}

TEST_CASE("sums, products and quotients of intervals enclose the exact result", "[interval]") {
  const int range = GENERATE(3, 60, 900);  // 900: results overflow and underflow
  Boxes boxes{.range = range};
  for (int i = 0; i < 3000; ++i) {
    const Interval x = boxes.box(), y = boxes.box();
    const double a = boxes.inside(x), b = boxes.inside(y);
    CAPTURE(x.lower(), x.upper(), y.lower(), y.upper(), a, b);
    REQUIRE(holds(x + y, Exact(a) + b));
    REQUIRE(holds(x - y, Exact(a) - b));
    REQUIRE(holds(x * y, Exact(a) * b));
    if (b != 0) REQUIRE(holds(x / y, Exact(a) / b));
  }
}

TEST_CASE("sums of doubles that fit in a double have no width", "[interval]") {
  CHECK(boost::numeric::width(Interval(0.5) + Interval(0.25)) == 0);
  CHECK(boost::numeric::width(Interval(1.0) - Interval(1.0)) == 0);
  CHECK(boost::numeric::width(Interval(0.0) * Interval(0.1)) == 0);
  const Interval inexact = Interval(0.1) + Interval(0.2);
  CHECK(inexact.upper() == step_up(inexact.lower()));
}

TEST_CASE("Division by an interval that holds zero gives every quotient", "[interval]") {
  const Interval whole = Interval(1.0) / Interval(-1.0, 2.0);
  CHECK(whole.lower() == -kInfinity);
  CHECK(whole.upper() == kInfinity);
  const Interval above = Interval(1.0, 2.0) / Interval(0.0, 4.0);
  CHECK(above.lower() <= 0.25);
  CHECK(above.lower() > 0.2499);
  CHECK(above.upper() == kInfinity);
  const Interval below = Interval(1.0) / Interval(-4.0, 0.0);
  CHECK(below.lower() == -kInfinity);
  CHECK(below.upper() >= -0.25);
  CHECK(below.upper() < -0.2499);
  CHECK(boost::numeric::empty(Interval(1.0) / Interval(0.0)));  // there is no quotient
}

TEST_CASE("Library functions of intervals enclose their values to 50 digits", "[interval]") {
  Boxes boxes{.range = 4};
  const auto check = [&](const char* name, auto of_box, auto exact, double low, double high) {
    for (int i = 0; i < 300; ++i) {
      const double a = boxes.between(low, high), b = boxes.between(low, high);
      const Interval x = i % 2 == 0 ? Interval(a) : Interval(std::min(a, b), std::max(a, b));
      const double at = boxes.inside(x);
      CAPTURE(name, x.lower(), x.upper(), at);
      REQUIRE(holds(of_box(x), exact(Exact(at))));
    }
  };
#define CHECK_FUNCTION(f, low, high)                              \
  check(                                                          \
      #f, [](const Interval& x) { return boost::numeric::f(x); }, \
      [](const Exact& x) { return Exact(boost::multiprecision::f(x)); }, low, high)
  CHECK_FUNCTION(sqrt, 0, 1e3);
  CHECK_FUNCTION(sin, -20, 20);
  CHECK_FUNCTION(cos, -20, 20);
  CHECK_FUNCTION(tan, -1.5, 1.5);
  CHECK_FUNCTION(asin, -1, 1);
  CHECK_FUNCTION(acos, -1, 1);
  CHECK_FUNCTION(atan, -50, 50);
  CHECK_FUNCTION(exp, -50, 50);
  CHECK_FUNCTION(log, 1e-6, 1e6);
  CHECK_FUNCTION(sinh, -10, 10);
  CHECK_FUNCTION(cosh, -10, 10);
  CHECK_FUNCTION(tanh, -5, 5);
#undef CHECK_FUNCTION
}

TEST_CASE("sin and cos reach 1 exactly where the box holds an extremum", "[interval]") {
  const double pi = std::numbers::pi;
  CHECK(sin(Interval(1, 2)).upper() == 1);
  CHECK(sin(Interval(-2, -1)).lower() == -1);
  CHECK(cos(Interval(-0.5, 0.5)).upper() == 1);
  CHECK(cos(Interval(3, 3.5)).lower() == -1);
  CHECK(boost::numeric::width(sin(Interval(0, 7))) == 2);
  Boxes boxes{.range = 4};
  for (int i = 0; i < 2000; ++i) {
    const double low = boxes.between(-40, 40);
    const double high = low + boxes.between(0, 6);
    // A maximum of cos lies at every whole turn, of sin a quarter turn later.
    const bool cosine_top = std::floor(high / (2 * pi)) >= std::ceil(low / (2 * pi));
    const bool sine_top = std::floor(high / (2 * pi) - 0.25) >= std::ceil(low / (2 * pi) - 0.25);
    const double cosine = cosine_top ? 1 : std::max(std::cos(low), std::cos(high));
    const double sine = sine_top ? 1 : std::max(std::sin(low), std::sin(high));
    CAPTURE(low, high);
    REQUIRE(std::abs(cos(Interval(low, high)).upper() - cosine) <= 1e-13);
    REQUIRE(std::abs(sin(Interval(low, high)).upper() - sine) <= 1e-13);
  }
}

TEST_CASE("real_power encloses x^p and grows or falls with x", "[interval]") {
  Boxes boxes{.range = 4};
  for (int i = 0; i < 2000; ++i) {
    const double a = boxes.between(0, 5), b = boxes.between(0, 5), p = boxes.between(-4, 6);
    const Interval x(std::min(a, b), std::max(a, b));
    const double at = boxes.inside(x);
    CAPTURE(x.lower(), x.upper(), p, at);
    const Interval y = real_power(x, p);
    REQUIRE(holds(y, pow(Exact(at), Exact(p))));
    const Interval first = real_power(Interval(x.lower()), p);
    const Interval last = real_power(Interval(x.upper()), p);
    REQUIRE(y.lower() == (p > 0 ? first : last).lower());
    REQUIRE(y.upper() == (p > 0 ? last : first).upper());
  }
}

TEST_CASE("real_power at zero and with the exponent zero", "[interval]") {
  CHECK(real_power(Interval(0.0), 2.5).lower() == 0);
  CHECK(real_power(Interval(0.0), 2.5).upper() == 0);
  CHECK(real_power(Interval(0.0, 4.0), 0.5).lower() == 0);
  CHECK(real_power(Interval(0.0, 4.0), 0.5).upper() >= 2);
  CHECK(real_power(Interval(0.0, 4.0), -0.5).upper() == kInfinity);
  CHECK(real_power(Interval(0.0, 4.0), -0.5).lower() <= 0.5);
  CHECK(real_power(Interval(0.0, 4.0), 0).lower() == 1);
  CHECK(real_power(Interval(0.0, 4.0), 0).upper() == 1);
}

TEST_CASE("An empty interval stays empty in real_power", "[interval]") {
  CHECK(boost::numeric::empty(real_power(Interval::empty(), 2.5)));
}

TEST_CASE("pi as an interval holds pi between neighbouring doubles", "[interval]") {
  const Interval box = pi<Interval>();
  CHECK(holds(box, boost::math::constants::pi<Exact>()));
  CHECK(box.upper() == step_up(box.lower()));
}

TEST_CASE("magnitude is the largest absolute value", "[interval]") {
  CHECK(magnitude(Interval(-3, 2)) == 3);
  CHECK(magnitude(Interval(-1, 2)) == 2);
  CHECK(magnitude(Interval(0.0)) == 0);
}

}  // namespace
}  // namespace camlaw::interval_test
