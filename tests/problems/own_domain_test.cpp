// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

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

}  // namespace camlaw::problems::own_domain_test
