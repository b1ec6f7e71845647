// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/laws/phases.h"
#include "kinematics/laws/trigonometric.h"
#include "kinematics/peaks.h"
#include "kinematics/shape.h"
#include "numerics/scalar/dual.h"

namespace camlaw::laws_phase_test {
namespace {

using Catch::Contains;
constexpr double kPi = std::numbers::pi;

template <class F>
void check_motion(const Law<double>& law, const F& wanted) {
  for (int i = 0; i <= 200; ++i) {
    const double x = (i + 0.3) / 201;  // never at a break
    const Motion<double> motion = law(x), exact = wanted(x);
    CAPTURE(x);
    CHECK(std::abs(motion.s - exact.s) <= 1e-14);
    CHECK(std::abs(motion.v - exact.v) <= 1e-13);
    CHECK(std::abs(motion.a - exact.a) <= 1e-12);
    CHECK(std::abs(motion.j - exact.j) <= 1e-11);
  }
}

TEST_CASE("Members of the sine-constant-cosine family are the laws they are named for",
          "[phases]") {
  check_motion(scca<double>(0.5, 0, 0.5), [](double x) { return cycloidal<double>()(x); });
  check_motion(scca<double>(0, 1, 0), [](double x) { return parabolic<double>()(x); });
  check_motion(scca<double>(0, 0, 1), [](double x) { return cosine<double>()(x); });
  check_motion(parabolic<double>(), [](double x) {
    const double y = 1 - x;
    return x < 0.5 ? Motion<double>{2 * x * x, 4 * x, 4, 0}
                   : Motion<double>{1 - 2 * y * y, 4 * y, -4, 0};
  });
}

TEST_CASE("The modified sine has its printed closed form", "[phases]") {
  // s = [pi x - sin(4 pi x) / 4] / (4 + pi) up to 1/8, and after 7/8 with 4 + pi x;
  // [2 + pi x - (9/4) sin(4 pi x / 3 + pi / 3)] / (4 + pi) between.
  check_motion(scca_of<double>(1, 0, 3, 4), [](double x) {
    const bool middle = x > 0.125 && x < 0.875;
    const double start = middle ? 2 : x < 0.5 ? 0 : 4, size = middle ? 2.25 : 0.25;
    const double w = middle ? 4 * kPi / 3 : 4 * kPi, angle = w * x + (middle ? kPi / 3 : 0);
    const double d = 4 + kPi, sine = size * std::sin(angle), cosine = size * std::cos(angle);
    return Motion<double>{(start + kPi * x - sine) / d, (kPi - w * cosine) / d, w * w * sine / d,
                          w * w * w * cosine / d};
  });
}

TEST_CASE("The modified trapezoid's acceleration is 1 / (1/4 - Ta + 2 Ta / pi)", "[phases]") {
  for (const double ta : {0.0, 0.05, 0.125, 0.2, 0.25}) {
    const auto law = scca<double>(2 * ta, 1 - 4 * ta, 2 * ta);
    CHECK(peaks(law).max_acceleration() == Approx(1 / (0.25 - ta + 2 * ta / kPi)).epsilon(1e-13));
    CHECK(peaks(law).max_velocity() == Approx(2).epsilon(1e-13));
  }
}

TEST_CASE("The universal curve of any seven durations is a unit stroke from rest to rest",
          "[phases]") {
  std::mt19937_64 random(43);
  std::uniform_real_distribution<double> share(0.05, 1);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> d(7);
    double sum = 0;
    for (double& x : d) sum += x = share(random);
    for (double& x : d) x /= sum;
    const auto law = universal(d);
    CAPTURE(i);
    REQUIRE(law.pieces().size() == 7);
    CHECK(law(0.0).s == 0);
    CHECK(std::abs(law(0.0).v) <= 1e-15);
    CHECK(std::abs(law(0.0).a) <= 1e-12);
    CHECK(std::abs(law(1.0).s - 1) <= 1e-14);
    CHECK(std::abs(law(1.0).v) <= 1e-13);
    CHECK(std::abs(law(1.0).a) <= 1e-12);
    CHECK(continuity(law) == 2);
    // Both levels by hand: speed gained is speed lost.
    const double up = law(d[0] + d[1] / 2).a, down = law(1 - d[6] - d[5] / 2).a;
    const double gained = up * (d[1] + 2 / kPi * (d[0] + d[2]));
    CHECK(gained == Approx(law(d[0] + d[1] + d[2]).v).epsilon(1e-12));
    CHECK(-gained == Approx(down * (d[5] + 2 / kPi * (d[4] + d[6]))).epsilon(1e-12));
    const double middle = d[0] + d[1] + d[2] + d[3] / 2;
    CHECK(std::abs(law(middle).a) <= 1e-12);
  }
}

TEST_CASE("Phases without duration are left out", "[phases]") {
  CHECK(scca<double>(0, 1, 0).pieces().size() == 2);
  CHECK(universal<double>({0.2, 0, 0.3, 0, 0, 0.5, 0}).pieces().size() == 3);
}

TEST_CASE("Trapezoidal velocity has the two accelerations of its durations", "[phases]") {
  // Peak velocity B = 1 / (1 - (t1 + t2) / 2); accelerations B / t1 and B / t2.
  const auto law = trapezoidal_velocity<double>(0.2, 0.5);
  const double b = 1 / (1 - 0.35);
  CHECK(law(0.1).a == Approx(b / 0.2).epsilon(1e-14));
  CHECK(law(0.4).v == Approx(b).epsilon(1e-14));
  CHECK(law(0.9).a == Approx(-b / 0.5).epsilon(1e-14));
  CHECK(law(1.0).s == Approx(1).epsilon(1e-15));
}

TEST_CASE("Trapezoidal acceleration has straight ramps", "[phases]") {
  // With ramp r and constant c: up phase gains C (r + c) and B (1 - 2 r - c) = 1.
  for (const auto& [r, c] : {std::pair{0.125, 0.25}, {0.1, 0.1}, {0.25, 0.0}, {0.05, 0.3}}) {
    const auto found = peaks(trapezoidal_acceleration<double>(r, c));
    const double b = 1 / (1 - 2 * r - c);
    CHECK(found.max_velocity() == Approx(b).epsilon(1e-12));
    CHECK(found.max_acceleration() == Approx(b / (r + c)).epsilon(1e-12));
    CHECK(found.max_jerk() == Approx(b / (r + c) / r).epsilon(1e-12));
  }
}

TEST_CASE("The S-curve has the peaks that were asked for, and no law is faster", "[phases]") {
  std::mt19937_64 random(47);
  std::uniform_real_distribution<double> share(0.05, 0.95);
  for (int i = 0; i < 100; ++i) {
    const double b = 1 + share(random);
    // C between the least (no jerk phase) and C / D = B / C (no constant phase).
    const double least = b * b / (b - 1);
    const double c = std::lerp(least, 2 * least, share(random));
    const double d = c / (1 - 1 / b - b / c);
    const auto found = peaks(s_curve<double>(b, c, d));
    CAPTURE(b, c, d);
    CHECK(found.max_velocity() == Approx(b).epsilon(1e-11));
    CHECK(found.max_acceleration() == Approx(c).epsilon(1e-11));
    CHECK(found.max_jerk() == Approx(d).epsilon(1e-11));
    CHECK(limit_index(found).value() == Approx(1).epsilon(1e-11));
  }
}

TEST_CASE("Printed peaks of an S-curve are taken within 0.1 % and scaled onto the stretch",
          "[phases]") {
  const double b = 1.6, c = 5.8, exact = c / (1 - 1 / b - b / c);
  const double printed = std::round(exact * 10) / 10;  // one decimal
  const auto law = s_curve<double>(b, c, printed);
  CHECK(std::abs(law(1.0).s - 1) <= 1e-14);
  CHECK(std::abs(law(1.0).v) <= 1e-13);
  const auto found = peaks(law);
  CHECK(found.max_velocity() == Approx(b).epsilon(2e-3));
  CHECK(found.max_acceleration() == Approx(c).epsilon(2e-3));
  // C / D is 0.0991 of the sum: 2 % more jerk takes 0.2 % off it.
  CHECK_THROWS_WITH(s_curve<double>(b, c, 1.02 * exact),
                    Contains("1/B + B/C + C/D") && Contains("0.998"));
  CHECK_THROWS_AS(s_curve<double>(b, c, 0.9 * exact), std::invalid_argument);
  CHECK_THROWS_AS(s_curve<double>(2, 8, 16), std::invalid_argument);     // sum 1.25
  CHECK_THROWS_AS(s_curve<double>(2, 16, 42.7), std::invalid_argument);  // B / C below C / D
}

TEST_CASE("Printed constants of the triple harmonic are taken within 0.1 % and scaled",
          "[phases]") {
  // The presets of MechDesigner's help; the 3-4-5 one is misprinted (0.0937 for 0.9).
  for (const auto& h : {std::array{6.04, 0.0, 0.73},
                        {5.96, 0.0, 0.9696},
                        {5.1968, 1.769, 0.6057},
                        {5.9, 0.704, 0.0937}}) {
    const auto law = triple_harmonic<double>(h[0], h[1], h[2]);
    CHECK(std::abs(law(1.0).s - 1) <= 1e-14);
    CHECK(std::abs(law(0.0).v) <= 1e-14);
    CHECK(law(0.25).a == Approx(h[0] - h[2]).epsilon(2e-3));  // sines 1, 0, -1
  }
  CHECK_THROWS_WITH((triple_harmonic<double>(5.9, 0.704, 0.9)),
                    Contains("h1 / (2 pi) + h2 / (4 pi) + h3 / (6 pi)") && Contains("1.0427"));
  const auto still = triple_harmonic<double>(9 * kPi / 4, 0, -3 * kPi / 4);
  CHECK(std::abs(still(0.0).j) <= 1e-11);
  CHECK(std::abs(still(0.5).j) <= 1e-11);
}

TEST_CASE("Durations that make no stretch are refused", "[phases]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(universal<double>({-0.1, 0.2, 0.2, 0.2, 0.2, 0.2, 0.1}),
                    Contains("-0.1") && Contains("negative"));
  CHECK_THROWS_WITH(universal<double>({0.1, 0.2, 0.2, 0.2, 0.2, 0.2, 0.1}),
                    Contains("add up to 1") && Contains("1.2"));
  CHECK_THROWS_WITH(universal<double>({0, 0, 0, 0.5, 0.2, 0.2, 0.1}), Contains("accelerating"));
  CHECK_THROWS_WITH(universal<double>({0.5, 0, 0, 0.5, 0, 0, 0}), Contains("decelerating"));
  CHECK_THROWS_AS(universal<double>({nan, 0.2, 0.2, 0.2, 0.2, 0.2, 0}), std::invalid_argument);
  CHECK_THROWS_WITH(scca<double>(0.5, 0.5, 0.5), Contains("no more than 1"));
  CHECK_THROWS_AS(scca<double>(0, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(trapezoidal_velocity<double>(0.6, 0.6), std::invalid_argument);
  CHECK_THROWS_AS(trapezoidal_velocity<double>(0, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(trapezoidal_acceleration<double>(0.2, 0.2), std::invalid_argument);
}

TEST_CASE("A universal curve of another number of durations than seven is refused", "[phases]") {
  CHECK_THROWS_AS(universal<double>({0.25, 0, 0.25, 0, 0.25, 0, 0.25, 0}), std::invalid_argument);
}

TEST_CASE("Fractions that add up to 1 leave no cruise, however their sum is rounded", "[phases]") {
  for (int q = 3; q < 20; ++q) {
    for (int a = 1; a < q - 1; ++a) {
      for (int b = 1; a + b < q; ++b) {
        CAPTURE(a, b, q);
        REQUIRE_NOTHROW(scca<double>(1.0 * a / q, 1.0 * b / q, 1.0 * (q - a - b) / q));
        REQUIRE_NOTHROW(scca_of<Interval>(a, b, q - a - b, q));
        const auto law = scca<double>(1.0 * a / q, 1.0 * b / q, 1.0 * (q - a - b) / q);
        CHECK(law.pieces().size() == 6);
      }
    }
  }
}

TEST_CASE("Derivatives by a duration agree with differences", "[phases]") {
  const auto law = scca<Dual>(Dual(0.3, 0), Dual(0.2, 1), Dual(0.3, 2));
  const double h = 1e-5;
  for (const double x : {0.07, 0.3, 0.62, 0.95}) {
    const auto slope = [&](double da, double db, double dc) {
      const auto at = [&](double t) {
        return scca<double>(0.3 + t * da, 0.2 + t * db, 0.3 + t * dc)(x).a;
      };
      return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);  // error O(h^4)
    };
    CAPTURE(x);
    CHECK(std::abs(law(x).a.v[0] - slope(1, 0, 0)) <= 1e-8);
    CHECK(std::abs(law(x).a.v[1] - slope(0, 1, 0)) <= 1e-8);
    CHECK(std::abs(law(x).a.v[2] - slope(0, 0, 1)) <= 1e-8);
  }
}

}  // namespace
}  // namespace camlaw::laws_phase_test
