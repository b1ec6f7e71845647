// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>

#include "kinematics/series.h"
#include "kinematics/springs/disc_spring.h"
#include "kinematics/springs/helical_spring.h"

namespace camlaw {
namespace {

/// DIN 2093 A 50: 50 x 25.4 x 3, h0 = 1.1 mm.
const DiscSpring<double> kA50{0.050, 0.0254, 0.003, 0.0011};
/// DIN 2093 B 40: 40 x 20.4 x 1.5, h0 = 1.15 mm. DIN 2093 C 63: 63 x 31 x 1.8, h0 = 2.35 mm.
const DiscSpring<double> kB40{0.040, 0.0204, 0.0015, 0.00115};
const DiscSpring<double> kC63{0.063, 0.031, 0.0018, 0.00235};

}  // namespace

TEST_CASE("forces at three quarters of the way to flat are those of DIN 2093", "[springs]") {
  CHECK(kA50.force(0.75 * 0.0011) == Approx(12.0e3).epsilon(5e-3));
  CHECK(kB40.force(0.75 * 0.00115) == Approx(2622).epsilon(2e-2));
  CHECK(kC63.force(0.75 * 0.00235) == Approx(4238).epsilon(2e-2));
}

TEST_CASE("stress at the inner upper edge is that of DIN 2093", "[springs]") {
  // Printed for A 50 at 0.75 h0: -1250 N/mm2 at edge OM, and about -2140 N/mm2 at edge I.
  CHECK(kA50.stress_upper_inner(0.75 * 0.0011) / 1e6 == Approx(-2142).epsilon(1e-3));
  CHECK(kA50.stress_upper_inner(0.0) == 0);
}

TEST_CASE("rate and work of a disc spring are the force's slope and integral", "[springs]") {
  for (const auto& spring : {kA50, kB40, kC63}) {
    double work = 0;
    constexpr int kSteps = 2000;
    const double h = spring.cone_height / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double s = (i + 0.5) * h;
      work += spring.force(s) * h;
      const auto f = spring.force(Series<double, 2>::variable(s, 1));
      CHECK(spring.rate(s) == Approx(f.c[1]).epsilon(1e-12).margin(1e-6));
    }
    CHECK(spring.work(spring.cone_height) == Approx(work).epsilon(1e-6));
  }
}

TEST_CASE("a stack adds forces in parallel and deflections in series", "[springs]") {
  const DiscSpringStack<double> stack{kB40, 2, 5};
  CHECK(stack.force(0.004) == Approx(2 * kB40.force(0.0008)));
  CHECK(stack.rate(0.004) == Approx(2 * kB40.rate(0.0008) / 5));
}

TEST_CASE("a flat disc is a linear spring to begin with", "[springs]") {
  // h0 = 0: F = 4 E t^4 / ((1 - mu^2) K1 De^2) (s/t + s^3 / (2 t^3)).
  DiscSpring<double> flat = kA50;
  flat.cone_height = 0;
  const double small = flat.force(1e-6), twice = flat.force(2e-6);
  CHECK(twice == Approx(2 * small).epsilon(1e-6));
}

TEST_CASE("a helical spring's rate, stress and surge frequency", "[springs]") {
  // d = 4, D = 32, n = 8.5: worked by hand. R = 81500 * 256 / (8 * 32768 * 8.5) = 9.3635 N/mm;
  // w = 8, k = 8.5 / 7.25; at 500 N tau = k 8 * 32 * 500 / (pi 64) = 746.35 N/mm2.
  const HelicalSpring<double> spring{0.004, 0.032, 8.5};
  CHECK(spring.rate() / 1000 == Approx(9.3635).epsilon(1e-4));
  CHECK(spring.shear_stress(500.0) / 1e6 == Approx(746.35).epsilon(1e-4));
  // EN 13906-1 prints f = 3560 d / (n D^2) sqrt(G / rho), d, D in mm, G in N/mm2, rho in kg/dm3.
  const double printed = 3560 * 4 / (8.5 * 32 * 32) * std::sqrt(81500.0 / 7.85);
  CHECK(spring.surge_frequency() == Approx(printed).epsilon(2e-3));
}

}  // namespace camlaw
