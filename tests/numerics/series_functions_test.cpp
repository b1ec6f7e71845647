// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "numerics/scalar/dual.h"
#include "numerics/scalar/series.h"

namespace camlaw::series_functions_test {
namespace {

/// Value and three derivatives of a generic f at x: two by nested dual numbers, the third by
/// differences of the second; and intervals that enclose them.
template <class F>
void check_function(const F& f, double x) {
  Dual2 t((Dual(x)));
  t.a.v[0] = 1, t.v[0] = Dual(1.0);
  const Dual2 expected = f(t);
  const auto at = [&](double place) {
    return derivatives(f(Series<double, 4>::variable(place, 1)));
  };
  const auto d = at(x);
  CHECK(d[0] == Approx(expected.a.a).epsilon(1e-14));
  CHECK(d[1] == Approx(expected.a.v[0]).epsilon(1e-13).margin(1e-14));
  CHECK(d[2] == Approx(expected.v[0].v[0]).epsilon(1e-13).margin(1e-13));
  const double h = 1e-3;  // Richardson: an error of fourth order
  const auto slope = [&](double step) { return (at(x + step)[2] - at(x - step)[2]) / (2 * step); };
  CHECK(d[3] == Approx((4 * slope(h) - slope(2 * h)) / 3).epsilon(1e-6).margin(1e-6));

  const auto point = f(Series<Interval, 4>::variable(Interval(x), Interval(1.0)));
  const auto box = f(Series<Interval, 4>::variable(Interval(x - 0.01, x + 0.01), Interval(1.0)));
  for (const double place : {x - 0.01, x, x + 0.005}) {
    const auto inside = f(Series<double, 4>::variable(place, 1));
    for (std::size_t k = 0; k < 4; ++k) CHECK(boost::numeric::in(inside.c[k], box.c[k]));
  }
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(boost::numeric::width(point.c[k]) < 1e-11 * (1 + magnitude(point.c[k])));
}

}  // namespace

TEST_CASE("series go through the functions of formulas", "[series]") {
  for (const double x : {-0.83, -0.2, 0.31, 0.77}) {
    INFO(x);
    check_function([](const auto& t) { return tan(t * t + t); }, x);
    check_function([](const auto& t) { return atan(t / (t * t + t)); }, x);
    check_function([](const auto& t) { return asin(t * t - t * sin(t)); }, x);
    check_function([](const auto& t) { return sin(cos(t) * t); }, x);
    check_function([](const auto& t) { return sqrt(cos(t)) - tan(-t); }, x);
  }
}

TEST_CASE("constants join series on either side", "[series]") {
  const auto t = Series<double, 3>::variable(0.4, 1);
  const auto d = derivatives(1.0 - (2.0 * t + 3.0) / 4.0 - 0.5 + t * 7.0 + (1.0 + t));
  CHECK(d[0] == Approx(1 - 3.8 / 4 - 0.5 + 2.8 + 1.4));
  CHECK(d[1] == Approx(-0.5 + 7 + 1));
  CHECK(d[2] == 0);
  CHECK(is_number(number<Series<double, 3>>(2.5), 2.5));
  CHECK_FALSE(is_number(t, 0.4));
  CHECK(value_of(t) == 0.4);
  CHECK(pi<Series<Interval, 2>>().c[0].lower() < pi<Series<Interval, 2>>().c[0].upper());
}

}  // namespace camlaw::series_functions_test
