// SPDX-License-Identifier: MIT
#include "kinematics/curve.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/differentiation/autodiff.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "numerics/scalar/dual.h"

namespace camlaw::curve_test {
namespace {

/// The independent way: the printed formula in long double, differentiated by Boost.
constexpr int kOrders = 5;
using Auto = decltype(boost::math::differentiation::make_fvar<long double, kOrders>(0.0L));
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;
const long double kPiLong = boost::math::constants::pi<long double>();

Auto half_ellipse(int integrations, const Auto& y) {
  const Auto root = sqrt(1 - y * y);
  const Auto area = (y * root + asin(y) + kPiLong / 2) / 2;
  if (integrations == 1) return area;
  // By parts: the integral of F is y F minus that of y F' = y sqrt(1 - y^2).
  return y * area + root * root * root / 3;
}

Auto ellipse(long double n, const Auto& y) {
  const Auto sine = sin(kPiLong * y);
  return (1 - cos(kPiLong * y) / sqrt(1 - (n * n - 1) / (n * n) * sine * sine)) / 2;
}

Auto inclined_sine(long double e, const Auto& y) {
  const long double turn = 2 * kPiLong;
  Auto t = y;
  for (int i = 0; i < 60; ++i) {  // far more Newton steps than needed
    t -= (t - e * sin(turn * t) / turn - y) / (1 - e * cos(turn * t));
  }
  return t - sin(turn * t) / turn;
}

template <class PieceCurve, class Formula>
void check_derivatives(const PieceCurve& curve, const Formula& formula, double low, double high) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(low, high);
  for (int i = 0; i < 50; ++i) {
    const double y = place(random);
    const auto d = curve.template derivatives<kCurveOrders>(y);
    const Auto exact = formula(boost::math::differentiation::make_fvar<long double, kOrders>(y));
    double size = 1;
    for (int k = 0; k <= kOrders; ++k) {
      CAPTURE(y, k);
      const auto wanted = static_cast<double>(exact.derivative(static_cast<std::size_t>(k)));
      size = std::max(size, std::abs(wanted));
      REQUIRE(std::abs(d[static_cast<std::size_t>(k)] - wanted) <= 1e-11 * size);
    }
    const auto few = curve.template derivatives<3>(y);
    for (std::size_t k = 0; k < 3; ++k) REQUIRE(few[k] == Approx(d[k]).epsilon(1e-14));
  }
}

TEST_CASE("Half-ellipses have the derivatives of their formula", "[curve]") {
  const int integrations = GENERATE(1, 2);
  check_derivatives(
      HalfEllipse<double>{integrations},
      [=](const Auto& y) { return half_ellipse(integrations, y); }, -0.97, 0.97);
}

TEST_CASE("The ellipse has the derivatives of its formula", "[curve]") {
  const double n = GENERATE(0.4, 0.9, 1.2, 3.0);
  check_derivatives(
      Ellipse<double>{n}, [=](const Auto& y) { return ellipse(n, y); }, 0, 1);
}

TEST_CASE("The inclined sine has the derivatives of its implicit formula", "[curve]") {
  const double e = GENERATE(-0.8, -0.3, 0.14, 0.6, 0.8);
  check_derivatives(
      InclinedSine<double>{e}, [=](const Auto& y) { return inclined_sine(e, y); }, 0, 1);
}

TEST_CASE("A power has the derivatives of its formula", "[curve]") {
  const double p = GENERATE(2.0, 2.5, 3.0, 7.3);
  check_derivatives(
      Power<double>{p}, [=](const Auto& y) { return pow(y, p); }, 0.01, 1);
}

TEST_CASE("Half-ellipses end with infinities of the limit's sign", "[curve]") {
  // sqrt(1 - y^2) rises from -1 like sqrt(h): signs +, -, +, ...; at 1 every derivative falls.
  for (const int integrations : {1, 2}) {
    const auto first = HalfEllipse<double>{integrations}.derivatives<kCurveOrders>(-1);
    const auto last = HalfEllipse<double>{integrations}.derivatives<kCurveOrders>(1);
    const auto m = static_cast<std::size_t>(integrations);
    for (std::size_t k = 0; k <= m; ++k) CHECK(first[k] == 0);
    CHECK(last[m] == 0);
    CHECK(last[m - 1] == Approx(kPi / 2).epsilon(1e-15));          // the area of the half-disc
    if (m == 2) CHECK(last[0] == Approx(kPi / 2).epsilon(1e-15));  // times its mean distance 1
    for (std::size_t k = m + 1; k < kCurveOrders; ++k) {
      CAPTURE(integrations, k);
      CHECK(first[k] == ((k - m) % 2 == 1 ? kInfinity : -kInfinity));
      CHECK(last[k] == -kInfinity);
    }
  }
}

TEST_CASE("A half-ellipse is held at its ends where rounding steps over them", "[curve]") {
  const double over = std::nextafter(1.0, 2.0);
  CHECK(HalfEllipse<double>{1}.derivatives<kCurveOrders>(over)[0] ==
        HalfEllipse<double>{1}.derivatives<kCurveOrders>(1)[0]);
  CHECK(HalfEllipse<double>{1}.derivatives<kCurveOrders>(-over)[0] == 0);
  const auto dual = HalfEllipse<Dual>{1}.derivatives<kCurveOrders>(Dual(over, 0));
  CHECK(dual[0].a == HalfEllipse<double>{1}.derivatives<kCurveOrders>(1)[0]);
  CHECK(dual[0].v[0] == 0);  // the slope sqrt(1 - y^2) vanishes
}

TEST_CASE("The round ellipse is the cosine law and the upright sine is the cycloid", "[curve]") {
  for (int i = 0; i <= 20; ++i) {
    const double y = i / 20.0;
    const auto round = Ellipse<double>{1}.derivatives<kCurveOrders>(y);
    const auto upright = InclinedSine<double>{0}.derivatives<kCurveOrders>(y);
    CHECK(std::abs(round[0] - (1 - std::cos(kPi * y)) / 2) <= 1e-15);
    CHECK(std::abs(upright[0] - (y - std::sin(2 * kPi * y) / (2 * kPi))) <= 1e-15);
    for (int k = 1; k < static_cast<int>(kCurveOrders); ++k) {
      // d^k cos(w y) = w^k cos(w y + k pi / 2)
      const double cosine = -std::pow(kPi, k) * std::cos(kPi * y + k * kPi / 2) / 2;
      const double turn = std::pow(2 * kPi, k);
      const double cycloid =
          (k == 1 ? 1 : 0) - turn * std::sin(2 * kPi * y + k * kPi / 2) / (2 * kPi);
      CAPTURE(y, k);
      CHECK(std::abs(round[static_cast<std::size_t>(k)] - cosine) <= 1e-13 * std::pow(kPi, k));
      CHECK(std::abs(upright[static_cast<std::size_t>(k)] - cycloid) <= 1e-13 * turn);
    }
  }
}

TEST_CASE("The root of Kepler's equation solves it", "[curve]") {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> lean(-0.99, 0.99), place(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const double e = i % 10 == 0 ? (i % 20 == 0 ? 0.99 : -0.99) : lean(random);
    const double y = i % 7 == 0 ? (i % 3) / 2.0 : place(random);
    const double t = detail::kepler_root(e, y);
    CAPTURE(e, y, t);
    REQUIRE(std::abs(t - e * std::sin(2 * kPi * t) / (2 * kPi) - y) <= 4e-16);
    REQUIRE(std::abs(t - y) <= std::abs(e) / (2 * kPi) + 1e-15);
  }
}

TEST_CASE("The interval root of Kepler's equation encloses the root for every e and y", "[curve]") {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> lean(-0.98, 0.98), place(0, 1);
  for (int i = 0; i < 2000; ++i) {
    // The answer comes first: y follows from t in long double.
    const double e = lean(random), t = place(random);
    const double y = static_cast<double>(t - e * std::sin(2 * kPiLong * t) / (2 * kPiLong));
    const double width = i % 2 == 0 ? 0 : 0.01 * place(random);
    const Interval es(e - width * place(random), e + width * place(random));
    const Interval ys(step_down(y) - width * place(random), step_up(y) + width * place(random));
    const Interval root = detail::kepler_root(es, ys);
    CAPTURE(e, t, y, width);
    REQUIRE(boost::numeric::in(t, root));
    // dt/dy is at most 1 / (1 - |e|), dt/de at most 1 / (2 pi) of that.
    const double steepest = 1 / (1 - std::min(0.9999, std::abs(e) + width));
    REQUIRE(boost::numeric::width(root) <= 1.2 * steepest * (3 * width + 1e-14));
  }
}

TEST_CASE("Derivatives of the root by e and y are those of the implicit function", "[curve]") {
  const double e = 0.6, y = 0.23;
  const Dual t = detail::kepler_root(Dual(e, 0), Dual(y, 1));
  const double slope = 1 - e * std::cos(2 * kPi * t.a);
  CHECK(t.v[0] == Approx(std::sin(2 * kPi * t.a) / (2 * kPi) / slope).epsilon(1e-13));
  CHECK(t.v[1] == Approx(1 / slope).epsilon(1e-13));
}

template <template <class> class Shape, class... P>
void check_encloses(double low, double high, P... parameters) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> place(low, high);
  for (int i = 0; i < 200; ++i) {
    const double a = place(random), b = place(random);
    const Interval box =
        i == 0 ? Interval(low, high)
               : Interval(std::min(a, b), i % 2 == 0 ? std::max(a, b) : std::min(a, b) + 1e-3);
    const auto d =
        Shape<double>{parameters...}.template as<Interval>().template derivatives<kCurveOrders>(
            box);
    for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0}) {
      const double y = std::min(high, std::lerp(box.lower(), box.upper(), share));
      const auto point = Shape<double>{parameters...}.template derivatives<kCurveOrders>(y);
      for (std::size_t k = 0; k < kCurveOrders; ++k) {
        CAPTURE(box.lower(), box.upper(), y, k, d[k].lower(), d[k].upper());
        const double rounding = std::isfinite(point[k]) ? 1e-9 * (1 + std::abs(point[k])) : 0;
        REQUIRE(d[k].lower() - rounding <= point[k]);
        REQUIRE(point[k] <= d[k].upper() + rounding);
      }
    }
  }
}

TEST_CASE("Curves over a box enclose their derivatives at every point of it", "[curve]") {
  SECTION("half-ellipse") { check_encloses<HalfEllipse>(-1, 1, 1); }
  SECTION("half-ellipse twice") { check_encloses<HalfEllipse>(-1, 1, 2); }
  SECTION("flat ellipse") { check_encloses<Ellipse>(0, 1, 3.0); }
  SECTION("ellipse") { check_encloses<Ellipse>(0, 1, 0.5); }
  SECTION("inclined sine") { check_encloses<InclinedSine>(0, 1, 0.7); }
  SECTION("inclined sine the other way") { check_encloses<InclinedSine>(0, 1, -0.7); }
  SECTION("power") { check_encloses<Power>(0, 1, 2.5); }
  SECTION("whole power") { check_encloses<Power>(0, 1, 3.0); }
}

TEST_CASE("A whole power has finite dual derivatives at 0", "[curve]") {
  const auto d = Power<Dual>{2}.derivatives<kCurveOrders>(Dual(0.0, 0));
  for (std::size_t k = 0; k < 4; ++k) {
    CAPTURE(k);
    CHECK(d[k].a == (k == 2 ? 2 : 0));
    CHECK(d[k].v[0] == (k == 1 ? 2 : 0));  // d/dy of the k-th derivative of y^2
  }
}

}  // namespace
}  // namespace camlaw::curve_test
