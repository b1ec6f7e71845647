// SPDX-License-Identifier: MIT
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "machines/springs/disc_spring_stack.h"
#include "machines/springs/helical_spring.h"
#include "tests/plain.h"

namespace camlaw::springs_test {
namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;

/// A disc from its catalogue's millimetres D_e x D_i x t, h_0.
DiscSpring disc(double outer, double inner, double thickness, double height) {
  return {outer / 1e3, inner / 1e3, thickness / 1e3, height / 1e3};
}

DiscSpring a50() { return disc(50, 25.4, 3, 1.1); }
DiscSpring b50() { return disc(50, 25.4, 2, 1.4); }
DiscSpring c50() { return disc(50, 25.4, 1.25, 1.6); }
DiscSpring b40() { return disc(40, 20.4, 1.5, 1.15); }
DiscSpring c63() { return disc(63, 31, 1.8, 2.35); }

/// A 125: l_0 = 10.6 mm, with contact flats.
DiscSpring with_flats() {
  DiscSpring spring = disc(125, 64, 8, 2.6);
  spring.thickness_ratio = 7.5 / 8;
  return spring;
}

/// The section turned as a rigid body by s / (a - b) about the circle of radius (a - b) / ln(a /
/// b), as Almen and Laszlo have it: the strain along the circumference at radius r, y above the
/// middle.
struct TurnedSection {
  const DiscSpring& spring;
  double s;
  double a = plain(spring.outer_diameter) / 2, b = plain(spring.inner_diameter) / 2;
  double centre = (a - b) / std::log(a / b), angle = s / (a - b);
  double modulus = plain(spring.youngs_modulus) /
                   (1 - plain(spring.poisson_ratio) * plain(spring.poisson_ratio));

  double stress(double r, double y) const {
    const double cone = (plain(spring.cone_height) - s / 2) / (a - b);
    return -modulus * angle / r * ((centre - r) * cone + y);
  }
  double energy() const {
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      for (int k = 0; k < kSteps; ++k) {
        const double r = b + (a - b) * (i + 0.5) / kSteps;
        const double y = plain(spring.thickness) * ((k + 0.5) / kSteps - 0.5);
        sum += std::pow(stress(r, y), 2) / (2 * modulus) * 2 * kPi * r;
      }
    }
    return sum * (a - b) * plain(spring.thickness) / (kSteps * kSteps);
  }
};

}  // namespace

TEST_CASE("forces at three quarters of the way to flat are those of DIN 2093", "[springs]") {
  const PlainNumbers numbers;
  // Three digits are printed.
  CHECK(plain(a50().force(0.75 * 0.0011)) == Approx(12.0e3).margin(50));
  CHECK(plain(b50().force(0.75 * 0.0014)) == Approx(4760).margin(5));
  CHECK(plain(c50().force(0.75 * 0.0016)) == Approx(1550).margin(5));
  CHECK(plain(b40().force(0.75 * 0.00115)) == Approx(2620).margin(5));
  CHECK(plain(c63().force(0.75 * 0.00235)) == Approx(4238).margin(1));
}

TEST_CASE("forces and stresses of series A are those of DIN 2093", "[springs]") {
  const PlainNumbers numbers;
  // D_e, D_i, t, h_0; force and tension at II at 3/4 of h_0; compression at OM when flat.
  const std::array<std::array<double, 7>, 13> rows{{{8, 4.2, 0.4, 0.2, 210, 1218, -1605},
                                                    {10, 5.2, 0.5, 0.25, 325, 1218, -1595},
                                                    {12.5, 6.2, 0.7, 0.3, 660, 1382, -1666},
                                                    {14, 7.2, 0.8, 0.3, 797, 1308, -1551},
                                                    {16, 8.2, 0.9, 0.35, 1013, 1301, -1555},
                                                    {18, 9.2, 1.0, 0.4, 1254, 1295, -1558},
                                                    {20, 10.2, 1.1, 0.45, 1521, 1290, -1560},
                                                    {22.5, 11.2, 1.25, 0.5, 1929, 1296, -1534},
                                                    {28, 14.2, 1.5, 0.65, 2841, 1274, -1562},
                                                    {31.5, 16.3, 1.75, 0.7, 3871, 1296, -1570},
                                                    {35.5, 18.3, 2.0, 0.8, 5187, 1332, -1611},
                                                    {40, 20.4, 2.25, 0.9, 6500, 1328, -1595},
                                                    {45, 22.4, 2.5, 1.0, 7716, 1296, -1534}}};
  for (const auto& [outer, inner, t, h, force, lower_inner, upper_middle] : rows) {
    INFO("A " << outer);
    const DiscSpring spring = disc(outer, inner, t, h);
    const double s = 0.75 * plain(spring.cone_height);
    CHECK(plain(spring.force(s)) == Approx(force).margin(0.6));
    CHECK(plain(spring.stress_lower_inner(s)) / 1e6 == Approx(lower_inner).margin(0.6));
    CHECK(plain(spring.stress_upper_middle(spring.cone_height)) / 1e6 ==
          Approx(upper_middle).margin(0.6));
  }
  const DiscSpring a25 = disc(25, 12.2, 1.5, 0.55);
  CHECK(plain(a25.force(0.75 * plain(a25.cone_height))) == Approx(2926).margin(0.6));
  CHECK(plain(a25.stress_lower_inner(0.75 * plain(a25.cone_height))) / 1e6 ==
        Approx(1419).margin(0.6));
  CHECK(plain(a25.stress_lower_outer(0.75 * plain(a25.cone_height))) / 1e6 ==
        Approx(1091).margin(0.6));
}

TEST_CASE("stresses are those of the section turned as a rigid body", "[springs]") {
  const PlainNumbers numbers;
  // All in the ratio 6 ((delta + 1) / (delta - 1) - 2 / ln delta) / ln delta, 0.992 for delta = 2:
  // the standard's K_1 has this in place of 1.
  for (const auto& spring : {a50(), b50(), c50(), c63()}) {
    for (const double share : {0.1, 0.5, 0.75, 1.0}) {
      const double s = share * plain(spring.cone_height), d = plain(spring.ratio()),
                   y = plain(spring.thickness) / 2;
      const double ratio = 6 * ((d + 1) / (d - 1) - 2 / std::log(d)) / std::log(d);
      const TurnedSection section{spring, s};
      const auto is = [&](double stress, double r, double above) {
        CHECK(stress == Approx(ratio * section.stress(r, above)).epsilon(1e-11));
      };
      is(plain(spring.stress_upper_inner(s)), section.b, y);
      is(plain(spring.stress_lower_inner(s)), section.b, -y);
      is(plain(spring.stress_lower_outer(s)), section.a, -y);
      is(plain(spring.stress_upper_outer(s)), section.a, y);
      is(plain(spring.stress_upper_middle(s)), section.centre, y);
      CHECK(plain(spring.work(s)) == Approx(section.energy()).epsilon(1e-2));
    }
  }
}

TEST_CASE("rate and work of a disc spring are the force's slope and integral", "[springs]") {
  const PlainNumbers numbers;
  for (const auto make : {&a50, &b40, &c63, &with_flats}) {
    const DiscSpring spring = make();
    double work = 0;
    constexpr int kSteps = 2000;
    const double h = plain(spring.flat_deflection()) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double s = (i + 0.5) * h;
      work += plain(spring.force(s)) * h;
      const auto f = plain_derivatives([&](const auto& x) { return make().force(x); }, s);
      CHECK(plain(spring.rate(s)) == Approx(f[1]).epsilon(1e-12).margin(1e-6));
    }
    CHECK(plain(spring.work(spring.flat_deflection())) == Approx(work).epsilon(1e-6));
  }
}

TEST_CASE("contact flats keep the force at three quarters of the cone", "[springs]") {
  const PlainNumbers numbers;
  const DiscSpring flats = with_flats();
  DiscSpring sharp = flats;
  sharp.thickness_ratio = 1;
  CHECK(plain(sharp.k4_squared()) == 1);
  CHECK(plain(flats.k4_squared()) > 1);
  const double s = 0.75 * plain(flats.cone_height);
  CHECK(plain(flats.force(s)) == Approx(plain(sharp.force(s))).epsilon(1e-13));
  CHECK(plain(flats.flat_deflection()) == Approx(0.0031).epsilon(1e-13));
  // C_1 and C_2 as the standard writes them.
  const double l = 10.6 / 8, r = 7.5 / 8;
  const double c1 = r * r / ((l / 4 - r + 0.75) * (5 * l / 8 - r + 0.375));
  const double c2 = c1 / (r * r * r) * (5 * (l - 1) * (l - 1) / 32 + 1);
  CHECK(plain(flats.k4_squared()) == Approx(-c1 / 2 + std::sqrt(c1 * c1 / 4 + c2)).epsilon(1e-12));
  sharp.thickness_ratio = 1 - 1e-12;
  CHECK(plain(sharp.k4_squared()) == Approx(1).epsilon(1e-10));
}

TEST_CASE("a stack adds forces in parallel and deflections in series", "[springs]") {
  const PlainNumbers numbers;
  const DiscSpringStack stack{b40(), 2, 5};
  CHECK(plain(stack.force(0.004)) == Approx(2 * plain(b40().force(0.0008))));
  CHECK(plain(stack.rate(0.004)) == Approx(2 * plain(b40().rate(0.0008)) / 5));
  CHECK(plain(stack.work(0.004)) == Approx(10 * plain(b40().work(0.0008))));
  CHECK(plain(stack.springs()) == 10);
  CHECK(plain(stack.flattening(0.004)) == Approx(0.0008 / 0.00115));
  // Two nested discs of 1.5 mm under a free height of 2.65 mm: 4.15 mm; flat 3 mm.
  CHECK(plain(stack.free_length()) == Approx(5 * 0.00415));
  CHECK(plain(stack.flat_length()) == Approx(5 * 0.003));
  CHECK(plain(stack.free_length()) - 5 * plain(b40().flat_deflection()) ==
        Approx(plain(stack.flat_length())));
  CHECK(plain(stack.mass(7850)) ==
        Approx(10 * 7850 * kPi / 4 * (0.04 * 0.04 - 0.0204 * 0.0204) * 0.0015));
  const DiscSpringStack flats{with_flats(), 3, 4};
  CHECK(plain(flats.flat_length()) == Approx(12 * 0.0075));
  CHECK(plain(flats.free_length()) == Approx(4 * (0.0106 + 2 * 0.0075)));
}

TEST_CASE("friction in a stack takes its share on the way in and gives it back", "[springs]") {
  const PlainNumbers numbers;
  const DiscSpringStack stack{b40(), 3, 5, 0.02, 0.03};
  CHECK(plain(stack.loading_force(0.004)) == Approx(plain(stack.force(0.004)) / 0.93));
  CHECK(plain(stack.return_force(0.004)) == Approx(plain(stack.force(0.004)) / 1.07));
  CHECK(plain(DiscSpringStack{b40(), 1, 5}.loading_force(0.004)) ==
        Approx(plain(b40().force(0.0008))));
}

TEST_CASE("the fewest springs for a deflection and a force", "[springs]") {
  const PlainNumbers numbers;
  CHECK(least_series(plain(b50().flat_deflection()), 10 * 0.75 * 0.0014, 0.75) == 10);
  CHECK(least_series(plain(b50().flat_deflection()), 10 * 0.75 * 0.0014 + 1e-9, 0.75) == 11);
  CHECK(least_parallel(plain(b50().force(0.001)), 3 * plain(b50().force(0.001))) == 3);
  CHECK(least_parallel(plain(b50().force(0.001)), 3 * plain(b50().force(0.001)) + 1e-3) == 4);
}

TEST_CASE("a flat disc is a linear spring to begin with", "[springs]") {
  const PlainNumbers numbers;
  // h0 = 0: F = 4 E t^4 / ((1 - mu^2) K1 De^2) (s/t + s^3 / (2 t^3)).
  DiscSpring flat = a50();
  flat.cone_height = 0;
  const double small = plain(flat.force(1e-6)), twice = plain(flat.force(2e-6));
  CHECK(twice == Approx(2 * small).epsilon(1e-6));
}

TEST_CASE("a helical spring's rate, stress and surge frequency", "[springs]") {
  const PlainNumbers numbers;
  // d = 4, D = 32, n = 8.5: worked by hand. R = 81500 * 256 / (8 * 32768 * 8.5) = 9.3635 N/mm;
  // w = 8, k = 8.5 / 7.25; at 500 N tau = 8 * 32 * 500 / (pi 64) = 636.62 N/mm2, tau_k = k tau.
  const HelicalSpring spring{0.004, 0.032, 8.5};
  CHECK(plain(spring.rate()) / 1000 == Approx(9.3635).epsilon(1e-4));
  CHECK(plain(spring.uncorrected_stress(500.0)) / 1e6 == Approx(636.62).epsilon(1e-5));
  CHECK(plain(spring.shear_stress(500.0)) / 1e6 == Approx(746.35).epsilon(1e-4));
  CHECK(plain(spring.deflection(500.0)) * 1e3 == Approx(500 / 9.3635).epsilon(1e-4));
  CHECK(plain(spring.work(0.02)) == Approx(plain(spring.force(0.02)) * 0.01));
  // By the twist of the wire, tau = G d s / (pi n D^2).
  CHECK(plain(spring.uncorrected_stress(spring.force(0.02))) ==
        Approx(81.5e9 * 0.004 * 0.02 / (kPi * 8.5 * 0.032 * 0.032)));
  // EN 13906-1 prints f = 3560 d / (n D^2) sqrt(G / rho), d, D in mm, G in N/mm2, rho in kg/dm3.
  const double printed = 3560 * 4 / (8.5 * 32 * 32) * std::sqrt(81500.0 / 7.85);
  CHECK(plain(spring.surge_frequency()) == Approx(printed).epsilon(2e-3));
}

TEST_CASE("a helical spring's lengths and mass", "[springs]") {
  const PlainNumbers numbers;
  // n_t = 10.5, L_c = 42 mm; S_a = 8.5 (0.0015 * 1024 / 4 + 0.4) = 6.664 mm.
  const HelicalSpring spring{0.004, 0.032, 8.5};
  CHECK(plain(spring.solid_length()) == Approx(0.042));
  CHECK(plain(spring.least_gaps()) == Approx(0.006664));
  CHECK(plain(spring.free_length(0.03, 1.5)) == Approx(0.042 + 0.009996 + 0.03));
  CHECK(plain(spring.mass()) == Approx(7850 * kPi * 0.004 * 0.004 / 4 * kPi * 0.032 * 10.5));
  CHECK(plain(spring.active_mass()) == Approx(plain(spring.mass()) * 8.5 / 10.5));
  CHECK(plain(spring.outer_diameter()) == Approx(0.036));
  CHECK(plain(spring.inner_diameter()) == Approx(0.028));
}

TEST_CASE("a helical spring buckles from a slenderness and a deflection on", "[springs]") {
  const PlainNumbers numbers;
  HelicalSpring spring{0.004, 0.032, 8.5};
  spring.youngs_modulus = 207e9;
  spring.shear_modulus = 79.3e9;
  // Textbooks: a steel spring with ends that turn does not buckle up to L_0 = 2.63 D.
  CHECK(std::isinf(plain(spring.buckling_deflection(2.62 * 0.032, 1))));
  CHECK(std::isfinite(plain(spring.buckling_deflection(2.64 * 0.032, 1))));
  CHECK(std::isinf(plain(spring.buckling_deflection(5.24 * 0.032, 0.5))));
  // Slender springs buckle at Euler's load pi^2 B / L^2, where each half of a turn bends and
  // twists: B = 4 L E I G / (pi n D (2 G + E)), I = pi d^4 / 64.
  const double length = 3, inertia = kPi * std::pow(0.004, 4) / 64;
  const double rigidity =
      4 * length * 207e9 * 79.3e9 * inertia / (kPi * 8.5 * 0.032 * (2 * 79.3e9 + 207e9));
  const double euler = kPi * kPi * rigidity / (length * length);
  CHECK(plain(spring.buckling_deflection(length, 1)) ==
        Approx(euler / plain(spring.rate())).epsilon(1e-3));
  CHECK(plain(spring.buckling_deflection(length, 2)) ==
        Approx(euler / 4 / plain(spring.rate())).epsilon(1e-3));
}

TEST_CASE("the nearness to buckling is 1 where a spring buckles", "[springs]") {
  const PlainNumbers numbers;
  const HelicalSpring spring{0.004, 0.032, 8.5};
  for (const double length : {0.1, 0.15, 0.4}) {
    const double critical = plain(spring.buckling_deflection(length, 1));
    CHECK(plain(spring.buckling_fraction(critical, length, 1)) == Approx(1));
    CHECK(plain(spring.buckling_fraction(0.9 * critical, length, 1)) < 1);
    CHECK(plain(spring.buckling_fraction(1.1 * critical, length, 1)) > 1);
  }
  // Past a L_0 nothing grows any more, nor does it fall.
  CHECK(plain(spring.buckling_fraction(0.07, 0.08, 1)) < 1);
  CHECK(plain(spring.buckling_fraction(0.079, 0.08, 1)) ==
        plain(spring.buckling_fraction(0.07, 0.08, 1)));
}

}  // namespace camlaw::springs_test
