// SPDX-License-Identifier: MIT
// Shapes by rules of formulas of two inputs, which samples of the formulas cannot refute.
#include "machines/model/shape_rules.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "numerics/formula/expression.h"

namespace camlaw::problems::shape_rules_test {
namespace {

using optim::Shape;
using Of = std::function<Expression(const Expression& x, const Expression& y)>;

struct Case {
  const char* text;
  Of formula;
  Shape shape;
};

Expression squared(const Expression& x) { return x * x; }

/// x in [-3, 5], y in [0.2, 6].
const std::array<RuledInput, 2> kInputs{
    {{Varies::Linearly, Interval(-3.0, 5.0)}, {Varies::Linearly, Interval(0.2, 6.0)}}};

/// Whether the middle of some two places goes against the shape.
bool is_refuted(const Formula& formula, Shape shape) {
  std::mt19937 random(7);
  const auto some = [&](const Interval& range) {
    return std::uniform_real_distribution<double>(range.lower(), range.upper())(random);
  };
  const auto at = [&](const std::array<double, 2>& u) {
    return formula(std::span<const double>(u));
  };
  for (int pair = 0; pair < 4000; ++pair) {
    const std::array<double, 2> a{some(kInputs[0].range), some(kInputs[1].range)};
    const std::array<double, 2> b{some(kInputs[0].range), some(kInputs[1].range)};
    const double first = at(a), second = at(b);
    const double middle = at({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2});
    const double mean = (first + second) / 2, slack = 1e-9 * (std::abs(first) + std::abs(second));
    if (std::isnan(first) || std::isnan(second)) continue;
    if (std::isnan(middle)) return true;
    if (is_convex(shape) && middle > mean + slack) return true;
    if (is_concave(shape) && middle < mean - slack) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("squares over concave functions, entropies and sums of exponentials have their shapes",
          "[shapes]") {
  using std::exp, std::log, std::sqrt;
  const std::vector<Case> cases{
      {"x^2 / y", [](auto x, auto y) { return x * x / y; }, Shape::Convex},
      {"(x^2 + (x - 2 y)^2) / sqrt y",
       [](auto x, auto y) { return (x * x + squared(x - number<Expression>(2) * y)) / sqrt(y); },
       Shape::Convex},
      {"exp(x)^2 / y", [](auto x, auto y) { return squared(exp(x)) / y; }, Shape::Convex},
      {"sqrt(exp(x)^2 + y^2)", [](auto x, auto y) { return sqrt(squared(exp(x)) + y * y); },
       Shape::Convex},
      {"y log y", [](auto, auto y) { return y * log(y); }, Shape::Convex},
      {"log(y) y + x", [](auto x, auto y) { return log(y) * y + x; }, Shape::Convex},
      {"(x + 4) log((x + 4) / y)",
       [](auto x, auto y) {
         const Expression z = x + number<Expression>(4);
         return z * log(z / y);
       },
       Shape::Convex},
      {"y log((x + 4) / y)",
       [](auto x, auto y) { return y * log((x + number<Expression>(4)) / y); }, Shape::Concave},
      {"log(exp(x) + exp(2 y) / sqrt y)",
       [](auto x, auto y) { return log(exp(x) + exp(number<Expression>(2) * y) / sqrt(y)); },
       Shape::Convex},
      {"exp(x) exp(y^2)", [](auto x, auto y) { return exp(x) * exp(y * y); }, Shape::Convex},
      // None of these is convex or concave.
      {"x^3 / y", [](auto x, auto y) { return x * x * x / y; }, Shape::General},
      {"x^2 / y^2", [](auto x, auto y) { return x * x / (y * y); }, Shape::General},
      {"x log y", [](auto x, auto y) { return x * log(y); }, Shape::General},
      {"exp(x) y", [](auto x, auto y) { return exp(x) * y; }, Shape::General}};
  for (const Case& c : cases) {
    INFO(c.text);
    const Formula formula =
        Formula::record(2, [&](std::span<const Expression> u) { return c.formula(u[0], u[1]); });
    CHECK(shape_by_rules(formula, kInputs).shape == c.shape);
    CHECK_FALSE(is_refuted(formula, c.shape));
  }
}

TEST_CASE("what has no value where a constant is 0 has no shape", "[shapes]") {
  const auto zero = [] { return Expression(0.0); };
  const std::vector<Case> cases{
      {"x / 0", [=](auto x, auto) { return x / zero(); }, Shape::General},
      {"atan(x / 0)", [=](auto x, auto) { return atan(x / zero()); }, Shape::General},
      {"x (1 / 0)", [=](auto x, auto) { return x * (Expression(1.0) / zero()); }, Shape::General},
      {"x + log 0", [=](auto x, auto) { return x + log(zero()); }, Shape::General},
      {"x / 2", [](auto x, auto) { return x / Expression(2.0); }, Shape::Linear}};
  for (const Case& c : cases) {
    INFO(c.text);
    const Formula formula =
        Formula::record(2, [&](std::span<const Expression> u) { return c.formula(u[0], u[1]); });
    CHECK(shape_by_rules(formula, kInputs).shape == c.shape);
  }
}

}  // namespace camlaw::problems::shape_rules_test
