// SPDX-License-Identifier: MIT
#include "machines/geneva/geneva.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/plain.h"

namespace camlaw::geneva_test {
namespace {

constexpr double kPi = std::numbers::pi;

using namespace testing;

/// Velocity ratio and higher derivatives from the angle by Taylor arithmetic.
template <class Geneva>
void check_derivatives(double slots) {
  const Geneva geneva{slots};
  const double half = plain(geneva.half_engagement());
  for (double share = -0.99; share < 1; share += 0.11) {
    const double alpha = share * half;
    const auto d =
        plain_derivatives([&](const auto& x) { return Geneva{slots}.at(x).angle; }, alpha);
    const auto of_ratio =
        plain_derivatives([&](const auto& x) { return Geneva{slots}.at(x).ratio; }, alpha);
    const auto exact = geneva.at(alpha);
    CHECK(plain(exact.ratio) == Approx(d[1]).epsilon(1e-12));
    CHECK(plain(exact.second) == Approx(d[2]).epsilon(1e-11).margin(1e-12));
    CHECK(plain(exact.third) == Approx(of_ratio[2]).epsilon(1e-11).margin(1e-10));
  }
}

template <class Geneva>
double greatest_second(const Geneva& geneva) {
  double greatest = 0;
  for (int i = 0; i <= 20000; ++i) {
    const double alpha = (i / 10000.0 - 1) * plain(geneva.half_engagement());
    greatest = std::max(greatest, std::abs(plain(geneva.at(alpha).second)));
  }
  return greatest;
}

}  // namespace

TEST_CASE("a planar Geneva has its known peaks", "[geneva]") {
  const PlainNumbers numbers;
  // Greatest velocity ratio sin(pi/n) / (1 - sin(pi/n)), and acceleration over omega^2
  // (J. E. Shigley, Theory of Machines, 1961; Dubbel).
  struct Known {
    double slots, ratio, acceleration;
  };
  for (const Known& k : {Known{4, 2.414, 5.407}, Known{5, 1.426, 2.299}, Known{6, 1.000, 1.350},
                         Known{8, 0.6199, 0.6998}}) {
    INFO(k.slots);
    const PlanarGeneva geneva{k.slots};
    CHECK(plain(geneva.at(0.0).ratio) == Approx(k.ratio).epsilon(5e-4));
    CHECK(greatest_second(geneva) == Approx(k.acceleration).epsilon(1e-3));
  }
}

TEST_CASE("a Geneva's wheel turns by a slot and is entered without shock", "[geneva]") {
  const PlainNumbers numbers;
  for (const double slots : {3.0, 4.0, 5.0, 6.0, 8.0, 12.0}) {
    INFO(slots);
    const PlanarGeneva planar{slots};
    const SphericalGeneva spherical{slots};
    const double end = plain(planar.half_engagement()), turn = plain(spherical.half_engagement());
    CHECK(plain(planar.at(end).angle) - plain(planar.at(-end).angle) == Approx(2 * kPi / slots));
    CHECK(plain(spherical.at(turn).angle) - plain(spherical.at(-turn).angle) ==
          Approx(2 * kPi / slots));
    CHECK(plain(planar.at(end).ratio) == Approx(0).margin(1e-12));
    CHECK(plain(spherical.at(turn).ratio) == Approx(0).margin(1e-12));
    // Entry without shock is not without a jump of acceleration: that of a pin on a circle.
    CHECK(plain(planar.at(end).second) == Approx(-std::tan(kPi / slots)).epsilon(1e-10));
  }
}

TEST_CASE("the wheel's angle is where its pin is", "[geneva]") {
  const PlainNumbers numbers;
  // The pin by vectors: planar beside the wheel's centre, spherical on a cone.
  const PlanarGeneva planar{5};
  const SphericalGeneva spherical{6};
  for (double alpha = -0.9; alpha < 0.95; alpha += 0.2) {
    const double r = plain(planar.crank());
    CHECK(plain(planar.at(alpha).angle) ==
          Approx(std::atan2(r * std::sin(alpha), 1 - r * std::cos(alpha))));
    const double gamma = kPi / 6;  // half a slot: the pin's cone about the driver's axis
    const double along = std::cos(gamma), across = std::sin(gamma) * std::sin(alpha);
    CHECK(plain(spherical.at(alpha).angle) == Approx(std::atan2(across, along)));
  }
}

TEST_CASE("derivatives of the Geneva's motion are exact", "[geneva]") {
  const PlainNumbers numbers;
  check_derivatives<PlanarGeneva>(4);
  check_derivatives<PlanarGeneva>(7);
  check_derivatives<SphericalGeneva>(4);
  check_derivatives<SphericalGeneva>(6);
}

}  // namespace camlaw::geneva_test
