// SPDX-License-Identifier: MIT
#include <Eigen/Core>
#include <boost/math/special_functions/legendre.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/laws/polynomial.h"
#include "numerics/linear/dense.h"
#include "numerics/scalar/dual.h"

namespace camlaw::laws_polynomial_test {
namespace {

using Catch::Contains;
using Coefficients = std::vector<double>;

const Coefficients& coefficients(const Law<double>& law) { return law.pieces().front().polynomial; }

void check_same(const Coefficients& c, const Coefficients& wanted, double tolerance = 1e-12) {
  for (std::size_t k = 0; k < std::max(c.size(), wanted.size()); ++k) {
    CAPTURE(k);
    CHECK(std::abs((k < c.size() ? c[k] : 0) - (k < wanted.size() ? wanted[k] : 0)) <= tolerance);
  }
}

/// Coefficients from the linear equations themselves: row by row a derivative at an end.
Coefficients solve_boundary(const Coefficients& begin, const Coefficients& end) {
  const auto m = static_cast<int>(begin.size()), n = static_cast<int>(end.size());
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(m + n, m + n);
  Eigen::VectorXd values(m + n);
  for (int row = 0; row < m + n; ++row) {
    const int order = row < m ? row : row - m;
    values(row) =
        row < m ? begin[static_cast<std::size_t>(order)] : end[static_cast<std::size_t>(order)];
    for (int k = order; k < m + n; ++k) {
      double falling = 1;  // k (k-1) ... (k - order + 1)
      for (int i = 0; i < order; ++i) falling *= k - i;
      if (row >= m || k == order) equations(row, k) = falling;
    }
  }
  const Eigen::VectorXd c = optim::solve_lu(equations, values);
  return {c.data(), c.data() + c.size()};
}

TEST_CASE("The boundary polynomial meets any conditions at both ends", "[polynomial]") {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> value(-3, 3);
  for (std::size_t m = 0; m <= 5; ++m) {
    for (std::size_t n = m == 0 ? 1 : 0; n <= 5; ++n) {
      Coefficients begin(m), end(n);
      for (double& x : begin) x = value(random);
      for (double& x : end) x = value(random);
      const auto law = boundary_polynomial<double>(begin, end);
      const auto first = law.derivatives<5>(0.0), last = law.derivatives<5>(1.0);
      CAPTURE(m, n);
      for (std::size_t k = 0; k < m; ++k) CHECK(std::abs(first[k] - begin[k]) <= 1e-12);
      for (std::size_t k = 0; k < n; ++k) CHECK(std::abs(last[k] - end[k]) <= 1e-8);
      check_same(coefficients(law), solve_boundary(begin, end), 1e-7);
    }
  }
}

TEST_CASE("Rest at both ends gives the classical polynomials", "[polynomial]") {
  check_same(coefficients(boundary_polynomial<double>({0, 0}, {1, 0})), {0, 0, 3, -2});
  check_same(coefficients(boundary_polynomial<double>({0, 0, 0}, {1, 0, 0})),
             coefficients(poly_3_4_5<double>()));
  check_same(coefficients(boundary_polynomial<double>({0, 0, 0, 0}, {1, 0, 0, 0})),
             coefficients(poly_4_5_6_7<double>()));
  check_same(coefficients(boundary_polynomial<double>({0, 0, 0, 0, 0}, {1, 0, 0, 0, 0})),
             coefficients(poly_5_6_7_8_9<double>()), 1e-10);
  CHECK(boundary_polynomial<double>({0, 0, 0}, {1, 0, 0}).ends() == Ends{});
  CHECK(boundary_polynomial<double>({0, 0, 0}, {1, 0, -5}).ends() ==
        Ends{End::Rest, End::Reversal});
  CHECK(boundary_polynomial<double>({0, 1, 0}, {1, 1, 2}).ends() ==
        Ends{End::Velocity, End::Motion});
}

TEST_CASE("The boundary polynomial has the derivatives by its conditions", "[polynomial]") {
  // s depends linearly on a condition, so its derivative is the polynomial of the unit condition.
  const auto law =
      boundary_polynomial<Dual>({Dual(0), Dual(0.3, 0), Dual(0)}, {Dual(1), Dual(0), Dual(2, 1)});
  const auto by_v0 = boundary_polynomial<double>({0, 1, 0}, {0, 0, 0});
  const auto by_a1 = boundary_polynomial<double>({0, 0, 0}, {0, 0, 1});
  for (const double x : {0.1, 0.5, 0.8}) {
    CHECK(law(x).a.v[0] == Approx(by_v0(x).a).epsilon(1e-12));
    CHECK(law(x).a.v[1] == Approx(by_a1(x).a).epsilon(1e-12));
  }
}

TEST_CASE("Stoddart's rule reproduces the classical polynomials", "[polynomial]") {
  check_same(coefficients(stoddart<double>({3, 4, 5})), {0, 0, 0, 10, -15, 6});
  check_same(coefficients(stoddart<double>({7, 5, 6, 4})), {0, 0, 0, 0, 35, -84, 70, -20});
  check_same(coefficients(stoddart<double>({3, 5, 7})),
             {0, 0, 0, 35 / 8., 0, -42 / 8., 0, 15 / 8.});
  check_same(coefficients(stoddart<double>({4, 6, 8, 10})), {0, 0, 0, 0, 10, 0, -20, 0, 15, 0, -4});
}

TEST_CASE("Stoddart's rule ends at 1 with as many derivatives 0 as exponents allow",
          "[polynomial]") {
  std::mt19937_64 random(37);
  std::uniform_real_distribution<double> gap(0.5, 2);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> exponents{2 + gap(random)};
    const std::size_t count = 2 + static_cast<std::size_t>(i % 5);
    while (exponents.size() < count) exponents.push_back(exponents.back() + gap(random));
    if (i % 3 == 0) exponents.back() = std::ceil(exponents.back());
    const auto law = stoddart<double>(exponents);
    const auto last = law.derivatives<6>(1.0);
    // Rounding grows with the constants: the largest product of q / (q - p), times p^k.
    double size = 1;
    for (const double p : exponents) {
      double c = 1;
      for (const double q : exponents) c *= q == p ? 1 : q / std::abs(q - p);
      size = std::max(size, c);
    }
    CHECK(std::abs(last[0] - 1) <= 1e-14 * size);
    for (std::size_t k = 1; k < count; ++k) {
      CAPTURE(i, k);
      CHECK(std::abs(last[k]) <= 1e-14 * size * std::pow(exponents.back(), k));
    }
    CHECK(law(0.0).s == 0);
    CHECK(law(0.0).v == 0);
  }
}

TEST_CASE("Stoddart's rule refuses exponents that make no law", "[polynomial]") {
  CHECK_THROWS_WITH(stoddart<double>({3}), Contains("at least two"));
  CHECK_THROWS_WITH(stoddart<double>({}), Contains("at least two"));
  CHECK_THROWS_WITH(stoddart<double>({3, 4, 3}), Contains("different"));
  CHECK_THROWS_WITH(stoddart<double>({1.9, 4}), Contains("at least 2"));
  CHECK_THROWS_AS(stoddart<double>({3, std::numeric_limits<double>::quiet_NaN()}),
                  std::invalid_argument);
}

TEST_CASE("The families of the spine-cutter study hold the classical polynomials", "[polynomial]") {
  check_same(coefficients(polynomial_5<double>(0)), coefficients(cubic<double>()));
  check_same(coefficients(polynomial_5<double>(-10)), coefficients(poly_3_4_5<double>()));
  check_same(coefficients(polynomial_7<double>(0)), coefficients(poly_4_5_6_7<double>()));
  check_same(coefficients(polynomial_7<double>(30)), coefficients(poly_3_4_5<double>()));
}

TEST_CASE("Every member of the study's families is a symmetric unit stroke", "[polynomial]") {
  for (const double parameter : {-30.0, -3.0, 4.2, 17.0, 48.0}) {
    for (const auto& law : {polynomial_5<double>(parameter), polynomial_7<double>(parameter)}) {
      const auto last = law(1.0);
      CHECK(std::abs(last.s - 1) <= 1e-14);
      CHECK(std::abs(last.v) <= 1e-12);
      CHECK(is_symmetric(law));
    }
    // s' = q (6 + 0.6 alpha - 3 alpha q): at x = 1/2 q = 1/4, and s''(0) = 6 + 0.6 alpha.
    const auto five = polynomial_5<double>(parameter);
    CHECK(five(0.5).v == Approx((6 + 0.6 * parameter - 0.75 * parameter) / 4).epsilon(1e-14));
    CHECK(five(0.0).a == Approx(6 + 0.6 * parameter).epsilon(1e-14));
    CHECK(polynomial_7<double>(parameter)(0.5).v ==
          Approx(parameter / 16 + (140 - 14 * parameter / 3) / 64).epsilon(1e-13));
  }
}

TEST_CASE("The first Legendre constant is 0.6 alpha of the degree-5 family", "[polynomial]") {
  for (const double alpha : {-12.0, -3.0, 0.0, 5.0}) {
    const auto law = legendre<double>({0.6 * alpha}), same = polynomial_5<double>(alpha);
    for (const double x : {0.0, 0.1, 0.4, 0.77, 1.0}) {
      CHECK(std::abs(law(x).s - same(x).s) <= 1e-15);
      CHECK(std::abs(law(x).a - same(x).a) <= 1e-13);
    }
  }
}

TEST_CASE("A Legendre law of order 25 has the acceleration of its formula", "[polynomial]") {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> c(12);  // c3, c5, ..., c25
  for (double& x : c) x = value(random);
  const auto law = legendre(c);
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.0, u = 1 - 2 * x;
    double acceleration = 6 * u;
    for (int k = 0; k < 12; ++k) {
      acceleration += c[static_cast<std::size_t>(k)] * boost::math::legendre_p(2 * k + 3, u);
    }
    CAPTURE(x);
    REQUIRE(std::abs(law(x).a - acceleration) <= 1e-10);
  }
  REQUIRE(law.pieces().size() > 1);
  for (std::size_t i = 0; i + 1 < law.pieces().size(); ++i) {
    const double x = law.pieces()[i].end;
    const auto left = law(x, Side::Left), right = law(x, Side::Right);
    CHECK(std::abs(left.s - right.s) <= 1e-14);
    CHECK(std::abs(left.v - right.v) <= 1e-12);
    CHECK(std::abs(left.a - right.a) <= 1e-10);
    CHECK(std::abs(left.j - right.j) <= 1e-8);
  }
  CHECK(std::abs(law(0.0).s) <= 1e-14);
  CHECK(std::abs(law(0.0).v) <= 1e-12);
  CHECK(std::abs(law(1.0).s - 1) <= 1e-14);
  CHECK(std::abs(law(1.0).v) <= 1e-12);
  CHECK(is_symmetric(law));
}

}  // namespace
}  // namespace camlaw::laws_polynomial_test
