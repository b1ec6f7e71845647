// SPDX-License-Identifier: MIT
#include "machines/geneva/geneva.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "numerics/scalar/series.h"

namespace camlaw::geneva_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Velocity ratio and higher derivatives from the angle by Taylor arithmetic.
template <class Geneva>
void check_derivatives(const Geneva& geneva) {
  const double half = geneva.half_engagement();
  for (double share = -0.99; share < 1; share += 0.11) {
    const double alpha = share * half;
    const auto d = derivatives(geneva.at(Series<double, 4>::variable(alpha, 1)).angle);
    const auto exact = geneva.at(alpha);
    CHECK(exact.ratio == Approx(d[1]).epsilon(1e-12));
    CHECK(exact.second == Approx(d[2]).epsilon(1e-11).margin(1e-12));
    CHECK(exact.third == Approx(d[3]).epsilon(1e-11).margin(1e-10));
  }
}

template <class Geneva>
double greatest_second(const Geneva& geneva) {
  double greatest = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double alpha = (i / 10000.0 - 1) * geneva.half_engagement();
    greatest = std::max(greatest, std::abs(geneva.at(alpha).second));
  }
  return greatest;
}

}  // namespace

TEST_CASE("a planar Geneva has its known peaks", "[geneva]") {
  // Greatest velocity ratio sin(pi/n) / (1 - sin(pi/n)), and acceleration over omega^2
  // (J. E. Shigley, Theory of Machines, 1961; Dubbel).
  struct Known {
    double slots, ratio, acceleration;
  };
  for (const Known& k : {Known{4, 2.414, 5.407}, Known{5, 1.426, 2.299}, Known{6, 1.000, 1.350},
                         Known{8, 0.6199, 0.6998}}) {
    INFO(k.slots);
    const PlanarGeneva<double> geneva{k.slots};
    CHECK(geneva.at(0.0).ratio == Approx(k.ratio).epsilon(5e-4));
    CHECK(greatest_second(geneva) == Approx(k.acceleration).epsilon(1e-3));
  }
}

TEST_CASE("a Geneva's wheel turns by a slot and is entered without shock", "[geneva]") {
  for (const double slots : {3.0, 4.0, 5.0, 6.0, 8.0, 12.0}) {
    INFO(slots);
    const PlanarGeneva<double> planar{slots};
    const SphericalGeneva<double> spherical{slots};
    const double end = planar.half_engagement(), turn = spherical.half_engagement();
    CHECK(planar.at(end).angle - planar.at(-end).angle == Approx(2 * kPi / slots));
    CHECK(spherical.at(turn).angle - spherical.at(-turn).angle == Approx(2 * kPi / slots));
    CHECK(planar.at(end).ratio == Approx(0).margin(1e-12));
    CHECK(spherical.at(turn).ratio == Approx(0).margin(1e-12));
    // Entry without shock is not without a jump of acceleration: that of a pin on a circle.
    CHECK(planar.at(end).second == Approx(-std::tan(kPi / slots)).epsilon(1e-10));
  }
}

TEST_CASE("the wheel's angle is where its pin is", "[geneva]") {
  // The pin by vectors: planar beside the wheel's centre, spherical on a cone.
  const PlanarGeneva<double> planar{5};
  const SphericalGeneva<double> spherical{6};
  for (double alpha = -0.9; alpha < 0.95; alpha += 0.2) {
    const double r = planar.crank();
    CHECK(planar.at(alpha).angle ==
          Approx(std::atan2(r * std::sin(alpha), 1 - r * std::cos(alpha))));
    const double gamma = kPi / 6;  // half a slot: the pin's cone about the driver's axis
    const double along = std::cos(gamma), across = std::sin(gamma) * std::sin(alpha);
    CHECK(spherical.at(alpha).angle == Approx(std::atan2(across, along)));
  }
}

TEST_CASE("derivatives of the Geneva's motion are exact", "[geneva]") {
  check_derivatives(PlanarGeneva<double>{4});
  check_derivatives(PlanarGeneva<double>{7});
  check_derivatives(SphericalGeneva<double>{4});
  check_derivatives(SphericalGeneva<double>{6});
}

}  // namespace camlaw::geneva_test
