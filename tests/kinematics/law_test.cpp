// SPDX-License-Identifier: MIT
#include "kinematics/law.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/laws/curved.h"
#include "kinematics/laws/phases.h"
#include "kinematics/laws/polynomial.h"
#include "kinematics/laws/trigonometric.h"
#include "numerics/scalar/dual.h"

namespace camlaw::law_test {
namespace {

using Catch::Contains;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Piece<double> line(double begin, double end) { return {begin, end, 0, {0, 1}, {}, {}}; }

bool holds(const Interval& box, double x) { return box.lower() <= x && x <= box.upper(); }

TEST_CASE("A law without pieces or with pieces that do not cover the stretch is refused", "[law]") {
  using Pieces = std::vector<Piece<double>>;
  const auto make = [](Pieces pieces) { return Law<double>(std::move(pieces), {}); };
  CHECK_THROWS_AS(make({}), std::invalid_argument);
  CHECK_THROWS_WITH(make({}), Contains("no pieces"));
  CHECK_THROWS_WITH(make({line(0, 0.4), line(0.5, 1)}), Contains("0.4") && Contains("0.5"));
  CHECK_THROWS_WITH(make({line(0, 0.6), line(0.5, 1)}), Contains("0.6") && Contains("0.5"));
  CHECK_THROWS_WITH(make({line(0.1, 1)}), Contains("0.1") && Contains("[0, 1]"));
  CHECK_THROWS_WITH(make({line(0, 0.9)}), Contains("0.9") && Contains("[0, 1]"));
  CHECK_THROWS_WITH(make({line(0, 0.5), line(0.5, 0.5), line(0.5, 1)}), Contains("end after"));
  CHECK_THROWS_AS(make({line(0, kNan)}), std::invalid_argument);
  CHECK_NOTHROW(make({line(0, 0.5), line(0.5 + 1e-15, 1)}));
}

TEST_CASE("piece_at takes the side that is asked for at a break", "[law]") {
  const Law<double> law({line(0, 0.25), line(0.25, 0.75), line(0.75, 1)}, {});
  CHECK(law.piece_at(0, Side::Left) == 0);
  CHECK(law.piece_at(0, Side::Right) == 0);
  CHECK(law.piece_at(0.25, Side::Left) == 0);
  CHECK(law.piece_at(0.25, Side::Right) == 1);
  CHECK(law.piece_at(0.5, Side::Left) == 1);
  CHECK(law.piece_at(0.75, Side::Left) == 1);
  CHECK(law.piece_at(0.75, Side::Right) == 2);
  CHECK(law.piece_at(1, Side::Left) == 2);
  CHECK(law.piece_at(1, Side::Right) == 2);
}

TEST_CASE("At a break the limit comes from the side that is asked for", "[law]") {
  const auto law = parabolic<double>();  // s'' = 4, then -4
  CHECK(law(0.5, Side::Left).a == 4);
  CHECK(law(0.5, Side::Right).a == -4);
  CHECK(law(0.5, Side::Left).s == law(0.5, Side::Right).s);
}

TEST_CASE("A law carried into other scalars keeps its values, pieces and ends", "[law]") {
  const auto law = scca<double>(0.2, 0.3, 0.1).with_ends({End::Reversal, End::Motion});
  const auto dual = law.as<Dual>();
  const auto box = law.as<Interval>();
  CHECK(dual.pieces().size() == law.pieces().size());
  CHECK(dual.ends() == law.ends());
  CHECK(box.as<double>().ends() == law.ends());
  for (const double x : {0.0, 0.13, 0.37, 0.5, 0.9, 1.0}) {
    const auto plain = law(x);
    CHECK(std::abs(dual(x).a.a - plain.a) <= 1e-14);
    for (int k = 0; k < kDualWidth; ++k) CHECK(dual(x).a.v[k] == 0);
    CHECK(holds(box(x).s, plain.s));
    CHECK(boost::numeric::width(box(x).a) <= 1e-12);
    CHECK(box.as<double>()(x).s == Approx(plain.s).epsilon(1e-15));
  }
}

TEST_CASE("A dual x carries the next derivative", "[law]") {
  const auto law = elliptic<double>(1.3);
  for (const double x : {0.1, 0.45, 0.8}) {
    const auto motion = law(Dual(x, 2));
    CHECK(motion.s.v[2] == Approx(law(x).v).epsilon(1e-12));
    CHECK(motion.v.v[2] == Approx(law(x).a).epsilon(1e-12));
    CHECK(motion.a.v[2] == Approx(law(x).j).epsilon(1e-12));
    CHECK(motion.a.v[0] == 0);
  }
}

TEST_CASE("Outside the stretch and at NaN a law is NaN", "[law]") {
  const auto law = cycloidal<double>();
  for (const double x : {-1e-300, std::nextafter(1.0, 2.0), 7.0, kNan}) {
    CHECK(std::isnan(law(x).s));
    CHECK(std::isnan(law(x).j));
    CHECK(std::isnan(law(Dual(x, 0)).v.a));
  }
  CHECK(boost::numeric::empty(law(Interval(1.5, 2)).s));
  CHECK(boost::numeric::empty(law(Interval(-2, -1)).a));
}

TEST_CASE("An interval of x gives every value across breaks", "[law]") {
  const auto parabola = parabolic<double>();
  const auto across = parabola(Interval(0.4, 0.7));
  CHECK(holds(across.a, 4));
  CHECK(holds(across.a, -4));
  CHECK(holds(across.v, 2));
  CHECK(holds(across.s, 0.32));          // 2 x^2
  CHECK(holds(across.s, 0.82 - 1e-15));  // 1 - 2 (1 - x)^2
  CHECK(across.v.upper() <= 2 + 1e-12);  // and no more than the values
  CHECK(holds(parabola(Interval(0.5)).a, 4));
  CHECK(holds(parabola(Interval(0.5)).a, -4));
  CHECK(holds(parabola(Interval(-1, 0.1)).v, 0.2));  // the part inside counts
}

TEST_CASE("An interval of x inside a rounding gap between pieces still has values", "[law]") {
  // The constructor takes breaks that differ by a few roundings.
  const double next = 0.5 + 4e-16;
  const Law<double> law({line(0, 0.5), line(next, 1)}, {});
  const double between = step_up(0.5);
  REQUIRE(between < next);
  CHECK(law(between).s == between);
  CHECK(holds(law(Interval(between)).s, between));
  const Law<double> late({{1e-16, 1, 0, {0, 1}, {}, {}}}, {});
  CHECK(holds(late(Interval(0.0)).s, 0));
}

TEST_CASE("The interval law holds at points where a derivative is infinite", "[law]") {
  const auto law = half_ellipse_velocity<double>();
  for (const double x : {0.0, 1.0}) {
    const auto point = law(Interval(x));
    CHECK(holds(point.s, x));
    CHECK(holds(point.v, 0));
    CHECK(holds(point.a, law(x).a));  // +inf, -inf
  }
}

TEST_CASE("Ends are written with the letters of VDI 2143", "[law]") {
  CHECK(to_string(Ends{}) == "R-R");
  CHECK(to_string({End::Rest, End::Reversal}) == "R-U");
  CHECK(to_string({End::Velocity, End::Motion}) == "G-B");
}

TEST_CASE("evaluate gives the law at every point, in any order and any length", "[law]") {
  std::vector<Law<double>> laws{cubic<double>(),
                                poly_5_6_7_8_9<double>(),
                                constant_velocity<double>(),
                                polynomial_law<double>({0.25}),
                                legendre<double>({0.3, -0.2, 0.1, 0.05, 0.02, 0.01}),
                                cycloidal<double>(),
                                scca<double>(0.2, 0.1, 0.3),
                                freudenstein_1_3_5<double>(),
                                half_ellipse_acceleration<double>(),
                                double_harmonic<double>()};
  for (int degree = 0; degree <= 12; ++degree) {
    std::vector<double> c;
    for (int k = 0; k <= degree; ++k) c.push_back(1.0 / (k + 1) - 0.3);
    laws.push_back(polynomial_law<double>(c));
  }
  std::mt19937_64 random(29);
  std::uniform_real_distribution<double> place(-0.02, 1.02);
  std::vector<double> x;
  for (int i = 0; i < 1500; ++i) x.push_back(place(random));
  std::sort(x.begin(), x.begin() + 1200);  // runs within pieces, then disorder
  for (const double special : {0.0, 0.5, 1.0, 0.125, 0.05, kNan, 0.25, 1.5}) x.push_back(special);
  for (const auto& law : laws) {
    std::vector<double> s(x.size()), v(x.size()), a(x.size()), j(x.size()), only_a(x.size());
    evaluate(law, x, {s, v, a, j});
    evaluate(law, x, {.s = {}, .v = {}, .a = only_a, .j = {}});
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto exact = law(x[i]);
      CAPTURE(x[i]);
      if (std::isnan(exact.s)) {
        REQUIRE((std::isnan(s[i]) && std::isnan(v[i]) && std::isnan(a[i]) && std::isnan(j[i])));
        continue;
      }
      // Terms of the 5-6-7-8-9 reach 1e3, 1e4, 1e5, 1e6; rounding is a few 1e-16 of them.
      REQUIRE(std::abs(s[i] - exact.s) <= 1e-12);
      REQUIRE(std::abs(v[i] - exact.v) <= 1e-11);
      REQUIRE((a[i] == exact.a || std::abs(a[i] - exact.a) <= 1e-10));
      REQUIRE((j[i] == exact.j || std::abs(j[i] - exact.j) <= 1e-9));
      REQUIRE(only_a[i] == a[i]);
    }
  }
}

TEST_CASE("evaluate refuses spans of another length than x", "[law]") {
  const auto law = cubic<double>();
  const std::vector<double> x{0, 0.5, 1};
  std::vector<double> good(3), shorter(2), longer(4);
  CHECK_THROWS_AS(evaluate(law, x, {shorter, {}, {}, {}}), std::invalid_argument);
  CHECK_THROWS_WITH(evaluate(law, x, {good, longer, {}, {}}),
                    Contains("v") && Contains("4") && Contains("3"));
  CHECK_THROWS_WITH(evaluate(law, x, {good, {}, {}, shorter}), Contains("j"));
  CHECK_NOTHROW(evaluate(law, x, {{}, {}, {}, {}}));
  CHECK_NOTHROW(evaluate(law, {}, {{}, {}, {}, {}}));
}

}  // namespace
}  // namespace camlaw::law_test
