// SPDX-License-Identifier: MIT
#include "numerics/formula/formula_latex.h"

#include <catch2/catch.hpp>

namespace camlaw::formula_latex_test {
namespace {

std::string latex(const std::string& formula) {
  return latex_of(parse_formula(formula),
                  [](const std::string& name) { return latex_symbol(name); });
}

}  // namespace

TEST_CASE("symbols have their indices below, and Greek letters as such", "[formula]") {
  CHECK(latex_symbol("F_0") == "F_{0}");
  CHECK(latex_symbol("R1") == "R_{1}");
  CHECK(latex_symbol("mu") == "\\mu");
  CHECK(latex_symbol("alpha_max") == "\\alpha_{\\mathrm{max}}");
  CHECK(latex_symbol("t12") == "t_{12}");
}

TEST_CASE("a formula is set with the parentheses that it needs and no others", "[formula]") {
  CHECK(latex("(a + b) * c") == "\\left(a + b\\right)\\,c");
  CHECK(latex("a - (b - c)") == "a - \\left(b - c\\right)");
  CHECK(latex("a - (b * c)") == "a - b\\,c");
  CHECK(latex("(a + b) / (c - d)") == "\\frac{a + b}{c - d}");
  CHECK(latex("(a / b)^2") == "\\left(\\frac{a}{b}\\right)^{2}");
  CHECK(latex("-a^2") == "-a^{2}");
  CHECK(latex("(-a)^2") == "\\left(-a\\right)^{2}");
  CHECK(latex("a * (b * c)") == "a\\,b\\,c");
  CHECK(latex("a * (-b)") == "a\\,\\left(-b\\right)");
  CHECK(latex("a * 2") == "a \\cdot 2");
  CHECK(latex("sqrt(a + b) * atan(c)") == "\\sqrt{a + b}\\,\\arctan\\left(c\\right)");
  CHECK(latex("abs(a - b)") == "\\left|a - b\\right|");
  CHECK(latex("1e-6 * a") == "1 \\cdot 10^{-6}\\,a");
  CHECK(latex("where_positive(a, b)") == "\\left[b\\right]_{a > 0}");
}

}  // namespace camlaw::formula_latex_test
