// SPDX-License-Identifier: MIT
#include "kinematics/laws/spline.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "kinematics/laws/polynomial.h"
#include "kinematics/laws/trigonometric.h"
#include "numerics/scalar/dual.h"

namespace camlaw::spline_test {
namespace {

using Catch::Contains;
using Values = std::vector<double>;

Values clamped_knots(int degree, const Values& interior) {
  Values knots(static_cast<std::size_t>(degree) + 1, 0.0);
  knots.insert(knots.end(), interior.begin(), interior.end());
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  return knots;
}

/// The definition: Cox and de Boor's recursion on basis functions, in long double.
long double basis(std::size_t i, int degree, const Values& t, long double x) {
  if (degree == 0) return t[i] <= x && x < t[i + 1] ? 1 : 0;
  const auto p = static_cast<std::size_t>(degree);
  const long double left = t[i + p] - t[i], right = t[i + p + 1] - t[i + 1];
  long double sum = 0;
  if (left > 0) sum += (x - t[i]) / left * basis(i, degree - 1, t, x);
  if (right > 0) sum += (t[i + p + 1] - x) / right * basis(i + 1, degree - 1, t, x);
  return sum;
}

long double recursion(int degree, const Values& interior, const Values& c, long double x) {
  const Values knots = clamped_knots(degree, interior);
  long double sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += c[i] * basis(i, degree, knots, x);
  return sum;
}

/// First derivative of f by central differences, extrapolated twice (error O(h^6)).
template <class F>
double slope(const F& f, double x, double h) {
  const auto central = [&](double step) { return (f(x + step) - f(x - step)) / (2 * step); };
  const double a = central(h), b = central(h / 2), c = central(h / 4);
  const double ab = (4 * b - a) / 3, bc = (4 * c - b) / 3;
  return (16 * bc - ab) / 15;
}

Values random_values(std::mt19937_64& random, std::size_t count, double low, double high) {
  std::uniform_real_distribution<double> value(low, high);
  Values result(count);
  for (double& x : result) x = value(random);
  return result;
}

TEST_CASE("A B-spline law agrees with the recursion that defines B-splines", "[spline]") {
  std::mt19937_64 random(61);
  for (int i = 0; i < 60; ++i) {
    const int degree = 1 + i % 6;
    Values knots = random_values(random, static_cast<std::size_t>(i % 5), 0.05, 0.95);
    std::sort(knots.begin(), knots.end());
    if (i % 3 == 0 && degree > 1 && knots.size() > 1) knots[1] = knots[0];
    const Values c =
        random_values(random, static_cast<std::size_t>(degree) + 1 + knots.size(), -2, 2);
    const auto law = b_spline(degree, knots, c);
    for (const double x : random_values(random, 20, 0, 1)) {
      CAPTURE(degree, knots, x);
      REQUIRE(std::abs(law(x).s - static_cast<double>(recursion(degree, knots, c, x))) <= 1e-12);
    }
  }
}

TEST_CASE("One piece of a high degree keeps its digits, at both ends too", "[spline]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<> between(-1, 2);
  for (const int degree : {12, 18, 22, 25}) {
    for (int round = 0; round < 4; ++round) {
      Values c(static_cast<std::size_t>(degree) + 1);
      for (double& x : c) x = between(random);
      c.front() = 0, c.back() = 1;
      const Law<double> law = b_spline<double>(degree, {}, c);
      for (int i = 0; i <= 64; ++i) {
        const double x = i / 64.0;
        // de Casteljau's algorithm adds up what lies between the coefficients.
        std::vector<long double> left(c.begin(), c.end());
        for (std::size_t n = left.size() - 1; n > 0; --n) {
          for (std::size_t k = 0; k < n; ++k) left[k] += x * (left[k + 1] - left[k]);
        }
        INFO("degree " << degree << " at " << x);
        CHECK(law(x).s == Approx(static_cast<double>(left[0])).margin(1e-9));
      }
    }
  }
}

TEST_CASE("Coefficients 1 give 1, and Greville's averages give x", "[spline]") {
  const Values interior{0.1, 0.35, 0.35, 0.8};
  for (const int degree : {2, 3, 5}) {
    const Values knots = clamped_knots(degree, interior);
    Values ones(static_cast<std::size_t>(degree) + 1 + interior.size(), 1), greville;
    for (std::size_t i = 0; i < ones.size(); ++i) {
      const auto first = knots.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      greville.push_back(std::accumulate(first, first + degree, 0.0) / degree);
    }
    const auto one = b_spline(degree, interior, ones), line = b_spline(degree, interior, greville);
    for (const double x : {0.0, 0.05, 0.35, 0.6, 0.99, 1.0}) {
      CHECK(std::abs(one(x).s - 1) <= 1e-15);
      CHECK(std::abs(one(x).v) <= 1e-13);
      CHECK(std::abs(line(x).s - x) <= 1e-15);
      CHECK(std::abs(line(x).v - 1) <= 1e-13);
      CHECK(std::abs(line(x).a) <= 1e-11);
    }
  }
}

TEST_CASE("The degree-5 Bezier curve of three zeros and three ones is the 3-4-5", "[spline]") {
  const auto law = b_spline<double>(5, {}, {0, 0, 0, 1, 1, 1});
  for (const double x : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    CHECK(std::abs(law(x).s - poly_3_4_5<double>()(x).s) <= 1e-15);
    CHECK(std::abs(law(x).j - poly_3_4_5<double>()(x).j) <= 1e-12);
  }
  CHECK(law.ends() == Ends{});
}

TEST_CASE("Derivatives of a B-spline law agree with extrapolated differences", "[spline]") {
  std::mt19937_64 random(67);
  const Values knots{0.2, 0.5, 0.5, 0.7};
  const auto law = b_spline(5, knots, random_values(random, 10, -1, 1));
  for (const double x : {0.1, 0.3, 0.42, 0.6, 0.85}) {  // 0.05 and more from any knot
    const double h = 0.04;
    CAPTURE(x);
    CHECK(law(x).v == Approx(slope([&](double t) { return law(t).s; }, x, h)).margin(1e-9));
    CHECK(law(x).a == Approx(slope([&](double t) { return law(t).v; }, x, h)).margin(1e-8));
    CHECK(law(x).j == Approx(slope([&](double t) { return law(t).a; }, x, h)).margin(1e-7));
  }
}

TEST_CASE("A knot repeated m times leaves continuity degree - m", "[spline]") {
  std::mt19937_64 random(71);
  for (const int degree : {3, 5}) {
    for (int m = 1; m <= degree; ++m) {
      const Values knots(static_cast<std::size_t>(m), 0.4);
      const Values c = random_values(random, static_cast<std::size_t>(degree + 1 + m), -1, 1);
      const auto law = b_spline(degree, knots, c).with_ends({End::Motion, End::Motion});
      CAPTURE(degree, m);
      CHECK(continuity(law) == degree - m);
    }
  }
}

TEST_CASE("Derivatives by coefficients are basis functions, by knots agree with differences",
          "[spline]") {
  const Values knots{0.3, 0.6}, c{0, 0, 0.2, 0.9, 1, 1};
  std::vector<Dual> moving{Dual(0.3, 0), Dual(0.6, 1)}, dual_c(c.begin(), c.end());
  dual_c[2] = Dual(0.2, 2);
  const auto law = b_spline<Dual>(3, moving, dual_c);
  for (const double x : {0.1, 0.45, 0.8}) {
    const auto at = [&](double a, double b) { return b_spline<double>(3, {a, b}, c)(x).s; };
    CAPTURE(x);
    CHECK(law(x).s.v[0] ==
          Approx(slope([&](double t) { return at(t, 0.6); }, 0.3, 0.02)).margin(1e-8));
    CHECK(law(x).s.v[1] ==
          Approx(slope([&](double t) { return at(0.3, t); }, 0.6, 0.02)).margin(1e-8));
    CHECK(law(x).s.v[2] ==
          Approx(static_cast<double>(basis(2, 3, clamped_knots(3, knots), x))).margin(1e-14));
  }
}

TEST_CASE("Knots and coefficients that do not fit are refused with the reason", "[spline]") {
  const auto make = [](int degree, Values knots, Values c) { b_spline<double>(degree, knots, c); };
  CHECK_THROWS_WITH(make(3, {0.5}, {0, 0, 1, 1}), Contains("4 given") && Contains("needs 5"));
  CHECK_THROWS_WITH(make(3, {0.6, 0.5}, {0, 0, 0, 1, 1, 1}), Contains("not decrease"));
  CHECK_THROWS_WITH(make(2, {0.5, 0.5, 0.5}, {0, 0, 0, 1, 1, 1}),
                    Contains("0.5") && Contains("repeated"));
  CHECK_THROWS_WITH(make(2, {0}, {0, 0, 1, 1}), Contains("strictly between"));
  CHECK_THROWS_WITH(make(2, {1}, {0, 0, 1, 1}), Contains("strictly between"));
  CHECK_THROWS_AS(make(2, {std::nan("")}, {0, 0, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(make(0, {}, {0}), std::invalid_argument);
}

Values uneven(std::mt19937_64& random, std::size_t count) {
  Values x = random_values(random, count, 0.5, 1.5);
  x.front() = 0;
  std::partial_sum(x.begin(), x.end(), x.begin());
  const double length = x.back();
  for (double& place : x) place /= length;
  return x;
}

TEST_CASE("A table gives back polynomials up to degree 5 from uneven samples", "[spline]") {
  std::mt19937_64 random(73);
  for (const bool with_velocity : {false, true}) {
    for (std::size_t count = 2; count <= 15; ++count) {
      const int conditions = static_cast<int>(with_velocity ? 2 * count : count);
      const auto terms = static_cast<std::size_t>(std::min(5, conditions - 1)) + 1;
      const auto exact = polynomial_law(random_values(random, terms, -2, 2));
      const Values x = uneven(random, count);
      Values s, v;
      for (const double place : x) {
        s.push_back(exact(place).s);
        if (with_velocity) v.push_back(exact(place).v);
      }
      const auto law = table(x, s, v);
      for (const double place : random_values(random, 30, 0, 1)) {
        CAPTURE(with_velocity, count, place);
        REQUIRE(std::abs(law(place).s - exact(place).s) <= 1e-12);
        REQUIRE(std::abs(law(place).v - exact(place).v) <= 1e-10);
        REQUIRE(std::abs(law(place).a - exact(place).a) <= 1e-8);
      }
    }
  }
}

TEST_CASE("A table goes through its samples, and has their velocities", "[spline]") {
  std::mt19937_64 random(79);
  for (const std::size_t count : {2, 3, 4, 5, 6, 7, 20}) {
    const Values x = uneven(random, count);
    const Values s = random_values(random, count, 0, 1), v = random_values(random, count, -1, 1);
    const auto through = table(x, s), with_velocity = table(x, s, v);
    for (std::size_t i = 0; i < count; ++i) {
      CAPTURE(count, i);
      CHECK(std::abs(through(x[i]).s - s[i]) <= 1e-12);
      CHECK(std::abs(with_velocity(x[i]).s - s[i]) <= 1e-12);
      CHECK(std::abs(with_velocity(x[i]).v - v[i]) <= 1e-10);
    }
  }
}

TEST_CASE("A table of a thousand samples of the cycloid is the cycloid", "[spline]") {
  const auto exact = cycloidal<double>();
  Values x, s;
  for (int i = 0; i < 1000; ++i) {
    x.push_back(i / 999.0);
    s.push_back(exact(x.back()).s);
  }
  const auto law = table(x, s);
  for (int i = 0; i <= 5000; ++i) {
    const double place = i / 5000.0;
    CAPTURE(place);
    REQUIRE(std::abs(law(place).s - exact(place).s) <= 1e-13);
    // s is good to 1e-16, so a to about 1e-16 * 16 / h^2 = 2e-9 inside; ends a few times more.
    REQUIRE(std::abs(law(place).a - exact(place).a) <= 2e-8);
  }
}

TEST_CASE("Derivatives of a table by its samples are those of a linear map", "[spline]") {
  const Values x{0, 0.1, 0.3, 0.45, 0.6, 0.85, 1}, s{0, 0.02, 0.2, 0.4, 0.7, 0.95, 1};
  std::vector<Dual> moving(s.begin(), s.end());
  moving[2] = Dual(s[2], 0);
  moving[5] = Dual(s[5], 3);
  const auto law = table(x, moving);
  Values third(7, 0.0), sixth(7, 0.0);
  third[2] = sixth[5] = 1;
  const auto by_third = table(x, third), by_sixth = table(x, sixth);
  for (const double place : {0.05, 0.3, 0.5, 0.9}) {
    CHECK(std::abs(law(place).s.a - table(x, s)(place).s) <= 1e-13);
    CHECK(law(place).s.v[0] == Approx(by_third(place).s).margin(1e-13));
    CHECK(law(place).a.v[3] == Approx(by_sixth(place).a).margin(1e-9));
    CHECK(law(place).s.v[1] == 0);
  }
}

TEST_CASE("Tables whose samples make no law are refused with the reason", "[spline]") {
  const auto make = [](Values x, Values s, Values v = {}) { table<double>(x, s, v); };
  CHECK_THROWS_WITH(make({0, 0.5, 1}, {0, 1}), Contains("same length") && Contains("3"));
  CHECK_THROWS_WITH(make({0, 0.5, 1}, {0, 0.5, 1}, {1, 1}), Contains("same length"));
  CHECK_THROWS_WITH(make({0}, {0}), Contains("at least two"));
  CHECK_THROWS_WITH(make({0, 0.9}, {0, 1}), Contains("from 0 to 1"));
  CHECK_THROWS_WITH(make({0.1, 1}, {0, 1}), Contains("from 0 to 1"));
  CHECK_THROWS_WITH(make({0, 0.6, 0.4, 1}, {0, 1, 1, 1}), Contains("increase") && Contains("0.4"));
  CHECK_THROWS_AS(make({0, 0.5, 0.5, 1}, {0, 1, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(make({0, std::nan(""), 1}, {0, 1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(make({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace camlaw::spline_test
