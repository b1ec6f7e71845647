// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

/// Formulas that have no value, or jump, at some places: nothing may be proved across these.
namespace camlaw::problems::own_domain_test {
namespace {

using optim::Verdict;

optim::Optimum solved(const std::string& formula, const std::string& rest) {
  const ProblemStatement problem = read_problem(
      "[machine]\nmoved_by = \"law\"\n[machine.parameters.p]\ndefault = 5\nlower = 0\nupper = 10\n"
      "[law]\nname = \"cycloidal\"\n[variables.p]\nlower = 0\nupper = 10\n[responses.own]\n"
      "formula = \"" +
          formula + "\"\n" + rest,
      "own.toml");
  return optim::optimise(BoundProblem(problem).space());
}

EvaluatedResponse evaluated(const std::string& file) {
  for (const EvaluatedResponse& response : evaluate(read_problem(file, "own.toml"))) {
    if (response.name == "own") return response;
  }
  throw std::logic_error("there is no own");
}

}  // namespace

TEST_CASE("a jump at one value of a variable is not proved away", "[formula][problems]") {
  // 10 + p, but 0 at p = 5.
  const auto jump = solved("unless_zero(p - 5, p + 10)", "[objective]\nminimize = \"own\"\n");
  CHECK_FALSE(jump.found.assessment.global);
  const auto sign = solved("p - 20 * abs(sign(p - 4.123))", "[objective]\nminimize = \"own\"\n");
  CHECK((!sign.found.assessment.global || sign.found.assessment.objective.value < -15));
}

TEST_CASE("a curve that has no value at some place is not proved", "[formula][problems]") {
  const std::string limit =
      "[objective]\nminimize = \"p\"\n[[constraints]]\nresponse = \"own\"\nlower = 20\n";
  for (const char* formula :
       {"p * unless_zero(x - 0.321734567, 10 + x)", "p * (10 + sqrt((x - 0.321734567)^2 - 1e-12))",
        "p * where_positive((x - 0.321734567)^2 - 1e-12, 10)",
        "p * (10 + 1e-9 * log((x - 0.321734567)^2 - 1e-12))",
        "p * (10 + ((x - 0.321734567)^2 - 1e-12)^1.5)",
        "p * (10 + asin(1 + 1e-12 - (x - 0.321734567)^2))"}) {
    INFO(formula);
    CHECK(solved(formula, limit).found.assessment.verdict != Verdict::Certified);
  }
  // The condition is small in the units of the SI, and so is the hole.
  const EvaluatedResponse hole = evaluated(
      "[machine]\n[machine.parameters.p]\nunit = \"mm\"\ndefault = 1\n[responses.own]\n"
      "formula = \"sqrt(p^4 * ((angle - 2.0012345)^2 - 1e-9))\"\nunit = \"mm2\"\n");
  CHECK_FALSE(hole.proved);
  // Where a root begins at the edge of the cycle it has a value everywhere.
  for (const char* formula : {"10 + sqrt(x)", "10 + sqrt(1 - x)", "acos(x)", "sqrt(x^2)"}) {
    INFO(formula);
    CHECK(evaluated(fmt::format("[machine]\nmoved_by = \"law\"\n[law]\nname = \"cycloidal\"\n"
                                "[responses.own]\nformula = \"{}\"\n",
                                formula))
              .proved);
  }
}

TEST_CASE("at a pulse a formula of the acceleration has no value", "[formula][problems]") {
  const EvaluatedResponse own = evaluated(
      "mechanism = \"die-press\"\n[law]\nname = \"constant-velocity\"\n[responses.own]\n"
      "formula = \"1 / (1 + a^2)\"\n");
  CHECK_FALSE((own.proved && std::isinf(own.highest)));
  CHECK_FALSE((own.proved && std::isinf(own.lowest)));
}

TEST_CASE("formulas that hold one another deeply are refused", "[formula][problems]") {
  std::string chain = "p", file = "[machine]\n[machine.parameters.p]\ndefault = 1\n";
  for (int i = 0; i < 900; ++i) chain += "*1";
  for (int i = 0; i < 60; ++i) {
    file += fmt::format("[responses.r{}]\nformula = \"{}\"\n", i,
                        i == 0 ? chain : fmt::format("r{}{}", i - 1, chain.substr(1)));
  }
  CHECK_THROWS_WITH(read_problem(file, "own.toml"), Catch::Contains("more than 40 levels deep"));
}

TEST_CASE("numbers of peaks that hold one another search each peak once", "[formula][problems]") {
  // Each holds the two before it: worked out one by one they would search 1.6^30 peaks.
  std::string file =
      "mechanism = \"die-press\"\n[law]\nname = \"cycloidal\"\n[responses.r0]\n"
      "formula = \"peak running_force / (1 N)\"\n[responses.r1]\nformula = "
      "\"r0 + highest running_force / (1 N)\"\n";
  for (int i = 2; i < 30; ++i) {
    file += fmt::format("[responses.r{}]\nformula = \"r{} + r{}\"\n", i, i - 1, i - 2);
  }
  file += "[responses.own]\nformula = \"r29\"\n";
  double highest = 0;
  for (const EvaluatedResponse& response : evaluate(read_problem(file, "own.toml"))) {
    if (response.name == "running_force") highest = response.highest;
  }
  CHECK(evaluated(file).value == Approx(1346269.0 * highest).epsilon(1e-12));
}

namespace {

/// A follower that goes up and down again, by this law on its way back.
std::string up_and_down(const std::string& law, const std::string& formula) {
  return "[machine]\nmoved_by = \"program\"\n[[program.segments]]\nname = \"rise\"\n"
         "angle = \"80 deg\"\nlaw = \"cycloidal\"\n[[program.segments]]\nname = \"high\"\n"
         "angle = \"60 deg\"\n[[program.segments]]\nname = \"return\"\nangle = \"100 deg\"\n"
         "law = \"" +
         law + "\"\n[[program.segments]]\nname = \"low\"\n[responses.own]\nformula = \"" + formula +
         "\"\n";
}

/// By a law alone.
std::string by_law(const std::string& law, const std::string& formula) {
  return "[machine]\nmoved_by = \"law\"\n[machine.parameters.p]\ndefault = 2\nlower = -5\n"
         "upper = 5\n[law]\nname = \"" +
         law + "\"\n[responses.own]\nformula = \"" + formula + "\"\n";
}

}  // namespace

TEST_CASE("what rounding leaves of a displacement beyond its ends has the value at the end",
          "[formula][problems]") {
  struct Known {
    const char* formula;
    double lowest, highest;
  };
  for (const char* law : {"cycloidal", "poly-3-4-5", "poly-4-5-6-7", "modified-sine",
                          "modified-trapezoid", "cosine"}) {
    for (const auto& [formula, lowest, highest] :
         {Known{"sqrt(30 * s)", 0, std::sqrt(30)}, Known{"sqrt(1 - s)", 0, 1}, Known{"s^1.5", 0, 1},
          Known{"asin(sqrt(s))", 0, std::acos(0.0)},
          Known{"acos(2 * s - 1)", 0, std::acos(-1.0)}}) {
      INFO(law << ": " << formula);
      const std::string matched =
          std::string(law) == "cosine" ? "[program]\nmatched = \"velocity\"\n" : "";
      const EvaluatedResponse own = evaluated(matched + up_and_down(law, formula));
      CHECK(std::abs(own.lowest - lowest) < 1e-7);
      CHECK(std::abs(own.highest - highest) < 1e-7);
      CHECK(own.proved);
    }
  }
}

TEST_CASE("a displacement that overshoots its ends is not moved there", "[formula][problems]") {
  // s = x - (1.5 sin(2 pi x) - 0.25 sin(4 pi x)) / (2 pi) is -0.0025 at x = 0.1.
  const std::string law = "[machine]\nmoved_by = \"law\"\n[law]\nname = \"fourier\"\na = [-0.5]\n";
  CHECK(evaluated(law + "[responses.own]\nformula = \"s\"\n").lowest < -2e-3);
  CHECK(std::isnan(evaluated(law + "[responses.own]\nformula = \"sqrt(s)\"\n").highest));
}

TEST_CASE("a curve that has a pole is reported as infinite there", "[formula][problems]") {
  const double inf = std::numeric_limits<double>::infinity();
  const auto own = [](const std::string& formula) {
    return evaluated(by_law("cycloidal", formula));
  };
  CHECK(own("1 / v + p").highest == inf);
  CHECK(own("1 / v + p").lowest == Approx(2.5));
  CHECK(own("a / v").highest == inf);
  CHECK(own("a / v").lowest == -inf);
  CHECK(own("1 / (s - 0.3)").highest == inf);
  CHECK(own("1 / (s - 0.3)").lowest == -inf);
  const EvaluatedResponse square = own("1 / (s - 0.3)^2");
  CHECK(square.highest == inf);
  CHECK(square.lowest == Approx(1 / 0.49));
  // s is 0.3 at this x.
  CHECK(square.highest_at == Approx(0.3964207).epsilon(1e-6));
  CHECK(own("log(abs(s - 0.3))").lowest == -inf);
  CHECK(own("-1 / sqrt(abs(s - 0.3))").lowest == -inf);
  // These have a bound, though not a slope.
  CHECK(own("sqrt(abs(s - 0.3))").lowest == Approx(0).margin(1e-6));
  CHECK(own("1 / (1e-6 + (s - 0.3)^2)").highest == Approx(1e6));
  CHECK(own("-abs(s - 0.3)^0.2").highest == Approx(0).margin(1e-2));
}

TEST_CASE("a power with an exponent that varies has a value at 0 where the exponent is above 0",
          "[formula][problems]") {
  const auto own = [](const std::string& formula) {
    return evaluated(by_law("cycloidal", formula));
  };
  const EvaluatedResponse root = own("s^(p / 4)");
  CHECK(root.lowest == 0);
  CHECK(root.highest == 1);
  CHECK(root.proved);
  CHECK(own("s^p").proved);
  CHECK(std::isnan(own("s^(p - 2)").highest));  // 0^0
  CHECK(std::isnan(own("s^(-p)").highest));     // no value at the rest
  CHECK(std::isnan(own("(s - 0.5)^p").highest));
  // A limit at the rest has slopes that a search can use.
  const auto found = solved("s^(1.5 + p / 10)",
                            "[objective]\nminimize = \"p\"\n[[constraints]]\nresponse = \"own\"\n"
                            "lower = 0\nupper = 1\n");
  CHECK(found.found.assessment.verdict == Verdict::Certified);
  CHECK(found.found.x.front() == Approx(0).margin(1e-9));
}

TEST_CASE("an objective without a value is told of, and no limit is blamed",
          "[formula][problems]") {
  const std::string rest =
      "[responses.twice]\nformula = \"2 * p\"\n[objective]\nminimize = \"own\"\n"
      "[[constraints]]\nresponse = \"twice\"\nlower = 20\n";  // met by p = 10 alone
  const auto none = solved("p * acos(2)", rest).found.assessment;
  CHECK(none.verdict == Verdict::Failed);
  CHECK(none.blamed.empty());
  CHECK_THAT(none.reason,
             Catch::Contains("the objective own is undefined: it has no value at the start") &&
                 Catch::Contains("it takes the arcsine or arccosine of 2"));
  const auto beyond = solved("log(5 - p)", rest).found.assessment;
  CHECK(beyond.verdict != Verdict::Infeasible);
  CHECK_THAT(beyond.reason, Catch::Contains("logarithm of -5"));
}

}  // namespace camlaw::problems::own_domain_test
