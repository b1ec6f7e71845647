// SPDX-License-Identifier: MIT
#include "kinematics/transform.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "kinematics/laws/curved.h"
#include "kinematics/laws/phases.h"
#include "kinematics/laws/polynomial.h"
#include "kinematics/laws/trigonometric.h"
#include "numerics/scalar/dual.h"

namespace camlaw::transform_test {
namespace {

void check_same(const Law<double>& law, const Law<double>& wanted, double tolerance) {
  for (int i = 0; i <= 100; ++i) {
    const double x = (i + 0.37) / 101;
    const auto a = law(x), b = wanted(x);
    CAPTURE(x);
    CHECK(std::abs(a.s - b.s) <= tolerance);
    CHECK(std::abs(a.v - b.v) <= 10 * tolerance);
    CHECK(std::abs(a.a - b.a) <= 100 * tolerance);
    CHECK(std::abs(a.j - b.j) <= 1000 * tolerance);
  }
}

/// Laws of every kind of term: symmetric, asymmetric, of one piece and of several.
std::vector<Law<double>> samples() {
  return {poly_3_4_5<double>(),
          stoddart<double>({3, 5, 7}),
          cycloidal<double>(),
          scca_of<double>(1, 0, 3, 4),
          universal<double>({0.1, 0.1, 0.15, 0.05, 0.2, 0.2, 0.2}),
          trapezoidal_velocity<double>(0.3, 0.3),
          half_ellipse_acceleration<double>(),
          elliptic<double>(1.2),
          inclined_sinusoid<double>(1.4),
          stoddart<double>({2.5, 4, 6.3})};
}

TEST_CASE("A reversed law is the law run backwards", "[transform]") {
  for (const auto& law : samples()) {
    const auto back = reversed(law);
    for (int i = 0; i <= 50; ++i) {
      const double x = (i + 0.37) / 51;
      const auto a = back(x), b = law(1 - x);
      CHECK(std::abs(a.s - (1 - b.s)) <= 1e-14);
      CHECK(std::abs(a.v - b.v) <= 1e-13);
      CHECK(std::abs(a.a + b.a) <= 1e-11);
      CHECK(std::abs(a.j - b.j) <= 1e-9);
    }
  }
}

TEST_CASE("A law reversed twice is the law", "[transform]") {
  for (const auto& law : samples()) {
    const auto twice = reversed(reversed(law));
    CHECK(twice.ends() == law.ends());
    CHECK(twice.pieces().size() == law.pieces().size());
    check_same(twice, law, 1e-13);
  }
}

TEST_CASE("A dwell-to-turn law reversed runs from turn to dwell", "[transform]") {
  for (const auto& law :
       {double_harmonic<double>(), rothbart_8<double>(), quick_return<double>()}) {
    const auto back = reversed(law);
    CHECK(to_string(law.ends()) == "R-U");
    CHECK(to_string(back.ends()) == "U-R");
    CHECK(std::abs(back(0.0).s) <= 1e-14);
    CHECK(std::abs(back(0.0).a + law(1.0).a) <= 1e-12);
    CHECK(continuity(back) == continuity(law));
  }
}

TEST_CASE("The crossover is the middle of a symmetric law, else where velocity peaks",
          "[transform]") {
  CHECK(crossover(poly_3_4_5<double>()).position == 0.5);
  CHECK(crossover(scca_of<double>(1, 0, 3, 4)).position == 0.5);
  // 3-5-7: s'' = (210 x - 840 x^3 + 630 x^5) / 8 = 0 at x^2 = 1/3.
  CHECK(crossover(stoddart<double>({3, 5, 7})).position ==
        Approx(1 / std::sqrt(3.0)).epsilon(1e-12));
}

TEST_CASE("A moved crossover lies where it was asked for, with continuous velocity",
          "[transform]") {
  const double at = GENERATE(0.02, 0.3, 0.5, 0.577, 0.8, 0.98);
  for (const auto& law : samples()) {
    const auto moved = with_crossover(law, at);
    CAPTURE(at);
    CHECK(moved.ends() == law.ends());
    CHECK(std::abs(moved(0.0).s) <= 1e-13);
    CHECK(std::abs(moved(1.0).s - 1) <= 1e-13);
    CHECK(std::abs(moved(1.0).v) <= 1e-10);
    for (std::size_t i = 0; i + 1 < moved.pieces().size(); ++i) {
      const double x = moved.pieces()[i].end;
      CHECK(std::abs(moved(x, Side::Left).s - moved(x, Side::Right).s) <= 1e-13);
      CHECK(std::abs(moved(x, Side::Left).v - moved(x, Side::Right).v) <= 1e-11);
    }
    for (int i = 1; i < 60; ++i) {
      const double x = i / 60.0;
      if (x < at) CHECK(moved(x).a >= -1e-9);
      if (x > at) CHECK(moved(x).a <= 1e-9);
    }
  }
}

TEST_CASE("A symmetric law keeps its velocity peak, and C becomes C / (2 c) and C / (2 (1 - c))",
          "[transform]") {
  for (const double at : {0.2, 0.4, 0.65}) {
    for (const auto& law :
         {poly_3_4_5<double>(), cycloidal<double>(), scca_of<double>(1, 2, 1, 4)}) {
      const auto before = peaks(law), after = peaks(with_crossover(law, at));
      CHECK(after.max_velocity() == Approx(before.max_velocity()).epsilon(1e-12));
      CHECK(after.high(Quantity::Acceleration).value ==
            Approx(before.max_acceleration() / (2 * at)).epsilon(1e-12));
      CHECK(after.low(Quantity::Acceleration).value ==
            Approx(-before.max_acceleration() / (2 * (1 - at))).epsilon(1e-12));
    }
  }
}

TEST_CASE("A crossover moved to where it is changes nothing", "[transform]") {
  for (const auto& law : samples())
    check_same(with_crossover(law, crossover(law).position), law, 1e-12);
}

TEST_CASE("A crossover moved there and back is the law again", "[transform]") {
  const auto law = poly_4_5_6_7<double>();
  check_same(with_crossover(with_crossover(law, 0.35), 0.5), law, 1e-11);
}

TEST_CASE("A law with a moved crossover has interval values everywhere", "[transform]") {
  std::mt19937_64 random(83);
  std::uniform_real_distribution<double> place(0.02, 0.98);
  for (int i = 0; i < 300; ++i) {
    const auto moved = with_crossover(poly_3_4_5<double>(), place(random));
    const double end = moved.pieces()[0].end, begin = moved.pieces()[1].begin;
    for (const double x : {0.0, end, begin, step_up(end), step_down(begin), 1.0}) {
      CAPTURE(end, begin, x);
      REQUIRE_FALSE(boost::numeric::empty(moved(Interval(x)).s));
      REQUIRE(std::abs(moved(Interval(x)).s.lower() - moved(x).s) <= 1e-12);
    }
  }
}

TEST_CASE("Derivatives by the crossover agree with differences", "[transform]") {
  const double at = 0.4, h = 1e-4;
  for (const auto& law : {poly_3_4_5<double>(), stoddart<double>({3, 5, 7})}) {
    const auto moved = with_crossover(law.as<Dual>(), Dual(at, 0));
    for (const double x : {0.1, 0.3, 0.6, 0.9}) {
      const auto v = [&](double c) { return with_crossover(law, c)(x).v; };
      const double slope =
          (8 * (v(at + h) - v(at - h)) - (v(at + 2 * h) - v(at - 2 * h))) / (12 * h);
      CHECK(moved(x).v.v[0] == Approx(slope).margin(1e-8));
    }
  }
}

TEST_CASE("A crossover outside the stretch is refused", "[transform]") {
  const auto law = cubic<double>();
  for (const double at : {0.0, 1.0, -0.5, 2.0, std::nan("")}) {
    CHECK_THROWS_WITH(with_crossover(law, at), Catch::Contains("between 0 and 1"));
  }
}

}  // namespace
}  // namespace camlaw::transform_test
