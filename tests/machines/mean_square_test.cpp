// SPDX-License-Identifier: MIT
// Mean squares of splines of high degree, against exact fractions.
#include "machines/model/mean_square.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kinematics/laws/spline.h"
#include "tests/machines/mechanism_fixture.h"

namespace camlaw::problems::mean_square_test {
namespace {

using Fraction = boost::multiprecision::cpp_rational;

Fraction binomial(int n, int k) {
  Fraction result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// int (sum c_i B_i)^2 of Bernstein polynomials of degree n, derived `order` times: the
/// derivative's coefficients are n (c_(i+1) - c_i), and the integral of B_i B_j is binomial(n, i)
/// binomial(n, j) / (binomial(2n, i + j) (2n + 1)).
double exact_mean_square(const std::vector<double>& coefficients, int order) {
  std::vector<Fraction> c(coefficients.begin(), coefficients.end());
  for (int k = 0; k < order; ++k) {
    const int n = static_cast<int>(c.size()) - 1;
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] = n * (c[i + 1] - c[i]);
    c.pop_back();
  }
  const int n = static_cast<int>(c.size()) - 1;
  Fraction sum = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      sum += c[static_cast<std::size_t>(i)] * c[static_cast<std::size_t>(j)] * binomial(n, i) *
             binomial(n, j) / binomial(2 * n, i + j);
    }
  }
  return static_cast<double>(Fraction(sum / (2 * n + 1)));
}

/// Coefficients that doubles hold exactly, of a steep rise.
std::vector<double> steep(int degree) {
  std::vector<double> c;
  for (int i = 0; i <= degree; ++i) {
    const double x = std::clamp((i / double(degree) - 0.3) / 0.4, 0.0, 1.0);
    c.push_back(std::round(std::ldexp(x * x * (3 - 2 * x), 20)) / std::ldexp(1.0, 20));
  }
  return c;
}

Member spline_of(int degree, const std::vector<double>& coefficients) {
  const Family& family = find_family("b-spline");
  Member result{&family, family.defaults()};
  result.arguments.values()[family.parameter("degree")] = {static_cast<double>(degree)};
  result.arguments.values()[family.parameter("coefficients")] = coefficients;
  return result;
}

/// The kernel in which the two middle coefficients vary.
double by_kernel(const Member& law, int order) {
  const std::size_t parameter = law.family->parameter("coefficients");
  const auto& all = law.arguments.list(parameter);
  const std::size_t middle = all.size() / 2;
  const auto binding = std::make_shared<const LawBinding>(
      law, std::vector<LawVariable>{{parameter, middle, 0}, {parameter, middle + 1, 1}});
  const auto kernel = mean_square_kernel(binding, order, nullptr);
  return kernel->value(std::vector<double>{all[middle], all[middle + 1]});
}

}  // namespace

TEST_CASE("mean squares of any degree are exact", "[mean-square]") {
  for (const int degree : {5, 9, 12, 18, 22, 25}) {
    const std::vector<double> coefficients = steep(degree);
    const Member law = spline_of(degree, coefficients);
    for (const int order : {1, 2, 3}) {
      INFO("degree " << degree << ", derivative " << order);
      const double exact = exact_mean_square(coefficients, order);
      CHECK(mean_square(law.law(), order).value() == Approx(exact).epsilon(1e-8));
      CHECK(mean_square(law.law<Dual>(), order).value().a == Approx(exact).epsilon(1e-8));
      CHECK(by_kernel(law, order) == Approx(exact).epsilon(1e-8));
      const Interval proved = mean_square(law.law<Interval>(), order).value();
      CHECK(proved.lower() <= exact);
      CHECK(proved.upper() >= exact);
      if (degree <= 12) CHECK(proved.upper() - proved.lower() < 1e-9 * exact);
    }
  }
}

TEST_CASE("a mean square over many knots keeps its digits", "[mean-square]") {
  constexpr int kKnots = 400, kDegree = 4;
  Member law = find_law("b-spline");
  law.arguments.values()[law.family->parameter("degree")] = {kDegree};
  std::vector<double> knots, coefficients;
  for (int i = 1; i < kKnots; ++i) knots.push_back(static_cast<double>(i) / kKnots);
  constexpr int kCoefficients = kKnots + kDegree;
  for (int i = 0; i < kCoefficients; ++i) {
    const double x = std::clamp((i - 2.0) / (kCoefficients - 5), 0.0, 1.0);
    coefficients.push_back(x * x * x * (10 + x * (-15 + 6 * x)));
  }
  const std::size_t parameter = law.family->parameter("coefficients");
  law.arguments.values()[law.family->parameter("knots")] = knots;
  law.arguments.values()[parameter] = coefficients;
  std::vector<LawVariable> variables;
  for (std::size_t i = 3; i + 3 < coefficients.size(); ++i) {
    variables.push_back({parameter, i, variables.size()});
  }
  const std::vector<double> u(coefficients.begin() + 3, coefficients.end() - 3);
  const auto binding = std::make_shared<const LawBinding>(law, variables);
  for (const int order : {2, 3}) {
    INFO("derivative " << order);
    CHECK(mean_square_kernel(binding, order, nullptr)->value(u) ==
          Approx(mean_square(law.law(), order).value()).epsilon(1e-8));
  }
}

TEST_CASE("mean squares of fast harmonics are those of Parseval", "[mean-square]") {
  // v = 1 - (cos 2 pi x + cos 2 pi n x) / 2: the mean of v^2 is 5/4, of s''^2 pi^2 (1 + n^2) / 2.
  for (const int n : {3, 30, 200, 1000}) {
    INFO("n " << n);
    Member law = find_law("fourier");
    std::vector<double> a(static_cast<std::size_t>(n) - 1, 0.0);  // from the second on
    a.back() = 0.5;
    law.arguments.values()[law.family->parameter("a")] = a;
    CHECK(mean_square(law.law(), 1).value() == Approx(1.25).epsilon(1e-11));
    const double turns = 1 + static_cast<double>(n) * n;
    CHECK(mean_square(law.law(), 2).value() ==
          Approx(std::numbers::pi * std::numbers::pi * turns / 2).epsilon(1e-11));
  }
}

TEST_CASE("a mean square over knots that let the derivative jump is not a number",
          "[mean-square]") {
  // A straight line as a spline of degree 2: s'' is 0 and jumps as soon as a coefficient moves.
  const Member line = find_law("b-spline degree=2 knots=0.5 coefficients=0,0.25,0.75,1");
  const std::size_t parameter = line.family->parameter("coefficients");
  const auto binding = std::make_shared<const LawBinding>(
      line, std::vector<LawVariable>{{parameter, 1, 0}, {parameter, 2, 1}});
  const std::vector<double> own{0.25, 0.75};
  const auto jerk = mean_square_kernel(binding, 3, nullptr);
  CHECK(std::isnan(jerk->value(own)));
  CHECK(jerk->why_undefined(own).find("jumps") != std::string::npos);
  const auto acceleration = mean_square_kernel(binding, 2, nullptr);
  CHECK(acceleration->value(own) == Approx(0).margin(1e-12));
  CHECK(acceleration->why_undefined(own).empty());
  // With what varies carried along it is seen too; alone the line has none.
  CHECK(mean_square(line.law(), 3).value() == Approx(0).margin(1e-12));
  auto arguments = line.arguments.as<Dual>();
  arguments.values()[parameter][1].v[0] = 1;
  CHECK_THAT(mean_square(line.family->make(arguments), 3).why(), Catch::Contains("infinite"));
}

}  // namespace camlaw::problems::mean_square_test
