// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/laws/catalogue.h"
#include "kinematics/laws/curved.h"
#include "kinematics/laws/phases.h"
#include "kinematics/laws/polynomial.h"
#include "kinematics/laws/trigonometric.h"
#include "kinematics/peaks.h"

namespace camlaw::limits_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST_CASE("The least acceleration is B^2 / (B - 1) up to B = 2", "[limits]") {
  CHECK(least_acceleration(2) == 4);
  CHECK(least_acceleration(5) == 4);
  CHECK(least_acceleration(1.5) == 4.5);
  CHECK(least_acceleration(1.25) == Approx(6.25).epsilon(1e-15));
  CHECK(least_acceleration(1) == kInfinity);
  CHECK(least_acceleration(0.3) == kInfinity);
}

TEST_CASE("Trapezoidal velocity attains the least acceleration, and other shares do not",
          "[limits]") {
  for (const double b : {1.1, 1.3, 1.5, 1.8, 2.0}) {
    const double t = 1 - 1 / b;  // B (1 - t) = 1
    const auto found = peaks(trapezoidal_velocity<double>(t, t));
    CHECK(found.max_velocity() == Approx(b).epsilon(1e-13));
    CHECK(found.max_acceleration() == Approx(least_acceleration(b)).epsilon(1e-13));
    const auto uneven = peaks(trapezoidal_velocity<double>(0.8 * t, 1.2 * t));
    CHECK(uneven.max_velocity() == Approx(b).epsilon(1e-13));
    CHECK(uneven.max_acceleration() > 1.1 * least_acceleration(b));
  }
}

TEST_CASE("The least dynamic moment is 9/4, and more where velocity or acceleration is limited",
          "[limits]") {
  CHECK(least_dynamic_moment(kInfinity, kInfinity) == Approx(2.25).epsilon(1e-14));
  CHECK(least_dynamic_moment(1.5, kInfinity) == Approx(2.25).epsilon(1e-14));
  for (const double b : {1.05, 1.2, 1.4}) {
    CHECK(least_dynamic_moment(b, kInfinity) == Approx(b * b * b / (3 * (b - 1))).epsilon(1e-13));
  }
  CHECK(least_dynamic_moment(1, kInfinity) == kInfinity);
  CHECK(least_dynamic_moment(1.5, 4.4) == kInfinity);  // C >= 4.5
  // At the least acceleration the law is trapezoidal velocity, and its moment B C. The stroke
  // hardly changes with the moment there.
  CHECK(least_dynamic_moment(1.5, 4.5) == Approx(1.5 * 4.5).epsilon(2e-5));
  CHECK(least_dynamic_moment(kInfinity, 4) == Approx(8).epsilon(2e-5));
}

TEST_CASE("With the least dynamic moment the velocity just covers the stroke", "[limits]") {
  // Stepped through: v' = min(C, M / v) up to B, to the middle.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int trial = 0; trial < 12; ++trial) {
    const double B = 1.05 + share(random);
    const double C = least_acceleration(B) * (1.05 + 4 * share(random));
    const double M = least_dynamic_moment(B, C);
    constexpr int kSteps = 400000;
    double v = 0, s = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double a = v > 0 ? std::min(C, M / v) : C;
      const double next = std::min(B, v + a * 0.5 / kSteps);
      s += (v + next) / 2 * 0.5 / kSteps;
      v = next;
    }
    INFO("B = " << B << ", C = " << C << ", M = " << M);
    CHECK(s == Approx(0.5).epsilon(1e-5));
  }
}

TEST_CASE("The least peak of each quantity is that at which a law takes all its time", "[limits]") {
  CHECK(least_peak(Quantity::Velocity, {}) == Approx(1).epsilon(1e-12));
  CHECK(least_peak(Quantity::Acceleration, {}) == Approx(4).epsilon(1e-12));
  CHECK(least_peak(Quantity::Jerk, {}) == Approx(32).epsilon(1e-12));
  CHECK(least_peak(Quantity::Moment, {}) == Approx(2.25).epsilon(1e-12));
  for (const double b : {1.1, 1.5, 1.9}) {
    const double c = least_peak(Quantity::Acceleration, {.velocity = b});
    CHECK(c == Approx(b * b / (b - 1)).epsilon(1e-12));
    CHECK(least_peak(Quantity::Velocity, {.acceleration = c * (1 + 1e-9)}) ==
          Approx(b).epsilon(1e-6));
    const double d = least_peak(Quantity::Jerk, {.velocity = b, .acceleration = 1.2 * c});
    CHECK(d == Approx(least_jerk(b, 1.2 * c)).epsilon(1e-12));
    CHECK(least_peak(Quantity::Acceleration, {.velocity = b, .jerk = d}) ==
          Approx(1.2 * c).epsilon(1e-9));
  }
  // The jerk's own limit says nothing of itself.
  CHECK(least_peak(Quantity::Jerk, {.jerk = 10}) == Approx(32).epsilon(1e-12));
  CHECK(least_peak(Quantity::Acceleration, {.jerk = 31}) == kInfinity);
  CHECK(least_peak(Quantity::Acceleration, {.velocity = 1}) == kInfinity);
}

TEST_CASE("No law from rest to rest has less than the least dynamic moment", "[limits]") {
  for (const Law<double>& law :
       {cycloidal<double>(), find_law("modified-sine").law(), half_ellipse_acceleration<double>(),
        scca<double>(0.1, 0.6, 0.3), trapezoidal_velocity<double>(0.25, 0.25)}) {
    const auto found = peaks(law);
    const double least = least_dynamic_moment(found.max_velocity(), found.max_acceleration());
    CHECK(least >= 2.25 * (1 - 1e-14));
    CHECK(found.max_dynamic_moment() >= least * (1 - 1e-12));
  }
}

/// Speed gained in a ramp of the given time that starts and ends without acceleration: jerk up,
/// acceleration held at C where it gets there, jerk down. Stepped through, not by formula.
double speed_gained(double time, double C, double D) {
  constexpr int kSteps = 4000;
  double speed = 0;
  const double h = time / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) * h;
    speed += h * std::min(C, D * std::min(t, time - t));  // midpoint rule on straight parts
  }
  return speed;
}

/// The least time by bisection: the stroke covered in a given total time grows with it. The motion
/// is symmetric in time, so a ramp to the top speed covers half the top speed in the mean.
double simulated_time(double B, double C, double D) {
  const auto stroke = [&](double total) {
    double ramp = total / 2;
    if (speed_gained(ramp, C, D) > B) {
      double low = 0;
      for (int i = 0; i < 50; ++i) {
        const double middle = (low + ramp) / 2;
        (speed_gained(middle, C, D) > B ? ramp : low) = middle;
      }
    }
    return speed_gained(ramp, C, D) * (total - ramp);
  };
  double low = 0, high = 1;
  while (stroke(high) < 1) high *= 2;
  for (int i = 0; i < 45; ++i) {
    const double middle = (low + high) / 2;
    (stroke(middle) < 1 ? low : high) = middle;
  }
  return (low + high) / 2;
}

TEST_CASE("The least time agrees with a simulated time-optimal motion in every regime",
          "[limits]") {
  struct Case {
    double B, C, D;
    const char* regime;
  };
  const Case cases[] = {{1.5, 6, 100, "velocity and acceleration reached"},
                        {1.2, 30, 60, "velocity reached, acceleration not"},
                        {9, 6, 200, "acceleration reached, velocity not"},
                        {9, 90, 40, "neither reached"}};
  for (const auto& [B, C, D, regime] : cases) {
    CAPTURE(regime);
    CHECK(least_time(B, C, D) == Approx(simulated_time(B, C, D)).epsilon(1e-6));
  }
}

TEST_CASE("Where all three peaks are reached the least time is 1/B + B/C + C/D", "[limits]") {
  CHECK(least_time(1.5, 6, 100) == Approx(1 / 1.5 + 1.5 / 6 + 6 / 100.0).epsilon(1e-15));
}

TEST_CASE("The least time covers unit stroke in each regime by algebra", "[limits]") {
  std::mt19937_64 random(53);
  std::uniform_real_distribution<double> decade(-1, 2);
  for (int i = 0; i < 2000; ++i) {
    const double B = std::pow(10, decade(random)), C = std::pow(10, decade(random)),
                 D = std::pow(10, decade(random));
    const double T = least_time(B, C, D);
    // The ramp's time for its speed v: two jerk phases of r = min(C / D, sqrt(v / D)) and a
    // constant one, v = D r (r + constant); then v (T - ramp) = 1 must hold at v = B or at T = 2
    // ramp.
    const auto ramp = [&](double v) {
      const double r = std::min(C / D, std::sqrt(v / D));
      return 2 * r + (v / (D * r) - r);
    };
    double v = B;
    if (2 * ramp(B) > T * (1 + 1e-12)) {
      double low = 0;
      for (int k = 0; k < 200; ++k) {
        const double middle = (low + v) / 2;
        (2 * ramp(middle) > T ? v : low) = middle;
      }
    }
    CAPTURE(B, C, D, T);
    REQUIRE(v * (T - ramp(v)) == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("Limits that are infinite leave the others", "[limits]") {
  CHECK(least_time(1.5, kInfinity, kInfinity) == 1 / 1.5);
  CHECK(least_time(1.5, 6, kInfinity) == Approx(1 / 1.5 + 1.5 / 6).epsilon(1e-15));
  CHECK(least_time(kInfinity, 4, kInfinity) == 1);  // parabolic: 4 is the least C
  CHECK(least_time(3, 4, kInfinity) == 1);
  CHECK(least_time(kInfinity, 8, 32) == Approx(1).epsilon(1e-15));
  // Velocity and jerk alone: v ramp + ..., the ramp to B takes 2 sqrt(B / D).
  CHECK(least_time(1.2, kInfinity, 60) == Approx(1 / 1.2 + 2 * std::sqrt(1.2 / 60)).epsilon(1e-15));
  CHECK(least_time(kInfinity, kInfinity, kInfinity) == 0);
}

TEST_CASE("32 is the least jerk, with B = 2 and C = 8", "[limits]") {
  CHECK(least_time(kInfinity, kInfinity, 32) == Approx(std::cbrt(32 / 32.0)).epsilon(1e-15));
  CHECK(least_time(kInfinity, kInfinity, 100) == Approx(std::cbrt(32 / 100.0)).epsilon(1e-15));
  const auto found = peaks(s_curve<double>(2, 8, 32));
  CHECK(found.max_velocity() == Approx(2).epsilon(1e-12));
  CHECK(found.max_acceleration() == Approx(8).epsilon(1e-12));
  CHECK(found.max_jerk() == Approx(32).epsilon(1e-12));
  CHECK(limit_index(found).value() == Approx(1).epsilon(1e-12));
}

TEST_CASE("The least time falls with every limit and is continuous between regimes", "[limits]") {
  std::mt19937_64 random(59);
  std::uniform_real_distribution<double> decade(-1, 2);
  for (int i = 0; i < 2000; ++i) {
    const double B = std::pow(10, decade(random)), C = std::pow(10, decade(random)),
                 D = std::pow(10, decade(random));
    const double T = least_time(B, C, D), more = 1 + 1e-7;
    for (const double next :
         {least_time(B * more, C, D), least_time(B, C * more, D), least_time(B, C, D * more)}) {
      CAPTURE(B, C, D);
      REQUIRE(next <= T * (1 + 1e-14));
      REQUIRE(next >= T * (1 - 2e-7));
    }
  }
}

TEST_CASE("The limit index of known laws is that of the reference study", "[limits]") {
  const auto index = [](const Law<double>& law) { return limit_index(peaks(law)).value(); };
  const auto near = [](double x) { return Approx(x).margin(0.0005); };
  CHECK(index(parabolic<double>()) == Approx(1).epsilon(1e-14));
  CHECK(index(scca_of<double>(1, 2, 1, 4)) == near(0.989));
  CHECK(index(cycloidal<double>()) == near(0.977));
  // Printed 0.967, a misprint: 1 / 1.6125 + 1.6125 / C with C = 4.656083237 and infinite D.
  CHECK(index(polynomial_5<double>(-3)) == Approx(0.966476).margin(5e-7));
  CHECK(index(scca_of<double>(1, 0, 3, 4)) == near(0.966));
  CHECK(index(cosine<double>()) == Approx(3 / std::numbers::pi).epsilon(1e-13));  // 0.955
  CHECK(index(poly_3_4_5<double>()) == near(0.954));
  CHECK(index(cubic<double>()) == Approx(11 / 12.0).epsilon(1e-13));  // 2/3 + 1/4
  CHECK(index(poly_4_5_6_7<double>()) == near(0.891));
  CHECK(index(half_ellipse_velocity<double>()) == Approx(std::numbers::pi / 4).epsilon(1e-13));
}

TEST_CASE("Only rest-to-rest laws have a limit index", "[limits]") {
  CHECK_FALSE(limit_index(peaks(constant_velocity<double>())).has_value());
  CHECK_FALSE(limit_index(peaks(harmonic<double>())).has_value());
  CHECK_FALSE(limit_index(peaks(double_harmonic<double>())).has_value());
}

TEST_CASE("The least jerk is where the least time is one", "[limits]") {
  for (const double b : {1.05, 1.3, 1.6, 1.99, 2.0, 2.5, 40.0, kInfinity}) {
    for (const double over : {1.01, 1.3, 1.9, 2.0, 3.0, 1e3, kInfinity}) {
      const double c = over * least_acceleration(b);
      INFO("B = " << b << ", C = " << c);
      const double d = least_jerk(b, c);
      CHECK(least_time(b, c, d) == Approx(1).epsilon(1e-12));
      CHECK(least_time(b, c, 0.999 * d) > 1);
    }
    CHECK(least_jerk(b, least_acceleration(b)) == kInfinity);
    CHECK(least_jerk(b, 3.9) == kInfinity);
  }
  CHECK(least_jerk(2, 8) == 32);
  CHECK(least_jerk(kInfinity, kInfinity) == 32);
  CHECK(least_jerk(1, 100) == kInfinity);
  CHECK(std::isnan(least_jerk(std::nan(""), 8)));
}

}  // namespace
}  // namespace camlaw::limits_test
