// SPDX-License-Identifier: MIT
#include "kinematics/shape.h"

#include <catch2/catch.hpp>

#include "kinematics/laws/curved.h"
#include "kinematics/laws/phases.h"
#include "kinematics/laws/polynomial.h"
#include "kinematics/laws/spline.h"
#include "kinematics/laws/trigonometric.h"

namespace camlaw::shape_test {
namespace {

TEST_CASE("Continuity of laws from dwell to dwell is the order before the first jump", "[shape]") {
  // The first derivative that is not 0 at x = 0 jumps there.
  CHECK(continuity(constant_velocity<double>().with_ends({})) == 0);
  CHECK(continuity(parabolic<double>()) == 1);
  CHECK(continuity(cubic<double>()) == 1);
  CHECK(continuity(cosine<double>()) == 1);
  CHECK(continuity(half_ellipse_velocity<double>()) == 1);
  CHECK(continuity(elliptic<double>(1.5)) == 1);
  CHECK(continuity(cycloidal<double>()) == 2);
  CHECK(continuity(poly_3_4_5<double>()) == 2);
  CHECK(continuity(scca_of<double>(1, 2, 1, 4)) == 2);
  CHECK(continuity(half_ellipse_acceleration<double>()) == 2);
  CHECK(continuity(poly_4_5_6_7<double>()) == 3);
  CHECK(continuity(poly_5_6_7_8_9<double>()) == 4);
  CHECK(continuity(stoddart<double>({2.5, 4, 6})) == 2);  // s'' ~ sqrt(x), s''' unbounded
}

TEST_CASE("Continuity counts what the ends declare", "[shape]") {
  CHECK(continuity(harmonic<double>()) == kSmooth);
  CHECK(continuity(constant_velocity<double>()) == kSmooth);
  CHECK(continuity(cosine<double>({End::Rest, End::Reversal})) == 1);
  CHECK(continuity(cosine<double>({End::Motion, End::Motion})) == kSmooth);
  CHECK(continuity(double_harmonic<double>()) == 3);  // s = (pi x)^4 / 16 - ...
  CHECK(continuity(cubic<double>().with_ends({End::Motion, End::Motion})) == kSmooth);
  CHECK(continuity(cubic<double>().with_ends({End::Reversal, End::Reversal})) == 2);  // s''' odd
  CHECK(continuity(cubic<double>().with_ends({End::Velocity, End::Rest})) == 1);
}

TEST_CASE("A displacement that jumps has continuity -1", "[shape]") {
  const Law<double> broken({{0, 0.5, 0, {0, 1}, {}, {}}, {0.5, 1, 0, {0.1, 1}, {}, {}}},
                           {End::Motion, End::Motion});
  CHECK(continuity(broken) == -1);
  const Law<double> kinked({{0, 0.5, 0, {0, 1}, {}, {}}, {0.5, 1, 0.5, {0.5, 2}, {}, {}}},
                           {End::Motion, End::Motion});
  CHECK(continuity(kinked) == 0);
}

TEST_CASE("Symmetric laws are known from others", "[shape]") {
  CHECK(is_symmetric(constant_velocity<double>()));
  CHECK(is_symmetric(poly_5_6_7_8_9<double>()));
  CHECK(is_symmetric(cosine<double>()));
  CHECK(is_symmetric(scca<double>(0.3, 0.2, 0.1)));
  CHECK(is_symmetric(half_ellipse_velocity<double>()));
  CHECK(is_symmetric(half_ellipse_acceleration<double>()));
  CHECK(is_symmetric(inclined_sinusoid<double>(1.3)));
  CHECK(is_symmetric(legendre<double>({0.3, -0.1, 0.2, 0.1, 0.1, 0.1})));
  CHECK(is_symmetric(b_spline<double>(3, {0.3, 0.7}, {0, 0, 0.1, 0.9, 1, 1})));
  CHECK_FALSE(is_symmetric(stoddart<double>({3, 5, 7})));
  CHECK_FALSE(is_symmetric(double_harmonic<double>()));
  CHECK_FALSE(is_symmetric(quick_return<double>()));
  CHECK_FALSE(is_symmetric(trapezoidal_velocity<double>(0.3, 0.31)));
  CHECK_FALSE(is_symmetric(universal<double>({0.1, 0.1, 0.15, 0.05, 0.2, 0.2, 0.2})));
  // A departure of 1e-9 is seen; one of rounding is not.
  CHECK_FALSE(is_symmetric(polynomial_law<double>({0, 0, 3, -2 + 1e-9})));
  CHECK(is_symmetric(polynomial_law<double>({0, 0, 3, -2 + 4e-16})));
}

TEST_CASE("Natural ends follow from velocity and acceleration there", "[shape]") {
  const auto ends = [](const Law<double>& law) { return to_string(natural_ends(law)); };
  CHECK(ends(poly_3_4_5<double>()) == "R-R");
  CHECK(ends(cycloidal<double>()) == "R-R");
  CHECK(ends(constant_velocity<double>()) == "G-G");
  CHECK(ends(cosine<double>()) == "U-U");
  CHECK(ends(double_harmonic<double>()) == "R-U");
  CHECK(ends(polynomial_law<double>({0, 0.5, 0.5})) == "B-B");
  CHECK(ends(polynomial_law<double>({0, 1, 0, 1})) == "G-B");
}

}  // namespace
}  // namespace camlaw::shape_test
