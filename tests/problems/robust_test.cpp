// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "machines/model/robust_number.h"
#include "numerics/sampling/sobol_points.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/tolerance/tolerance.h"
#include "tests/problems/complaint.h"

// Robust objectives and limits with a reliability, against closed forms.
namespace camlaw::problems::robust_test {

using Catch::Contains;

namespace {

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

/// A formula f in b and c; b is normal with a deviation of 0.2.
std::string machine(const std::string& formula, const std::string& more) {
  return "[machine]\n[machine.parameters.b]\ndefault = 1\nlower = -20\nupper = 20\n"
         "[machine.parameters.c]\ndefault = 2\nlower = -20\nupper = 20\n"
         "[responses.f]\nformula = '" +
         formula +
         "'\n[variation.b]\nstandard_deviation = 0.2\n"
         "[variables.b]\nlower = -9\nupper = 9\n[variables.c]\nlower = -9\nupper = 9\n" +
         more;
}

optim::Function objective_of(const std::string& formula, const std::string& robust) {
  const BoundProblem bound(
      read(machine(formula, "[objective]\nminimize = 'f'\nrobust = '" + robust + "'\n")));
  return bound.problem({}).objectives.front().response.function();
}

}  // namespace

TEST_CASE("What is taken of many parts is read as it is written", "[variation]") {
  CHECK(parse_robust("mean").text() == "mean");
  CHECK(parse_robust("mean + 3 sigma").factor == 3);
  CHECK(parse_robust("mean+2.5sigma").text() == "mean + 2.5 sigma");
  CHECK(parse_robust("mean - sigma").factor == -1);
  CHECK(parse_robust("quantile 0.99").share == 0.99);
  CHECK(parse_robust("quantile 0.99").parts() >= 400);
  for (const char* text : {"", "median", "mean + sigma 3", "mean + -3 sigma", "mean3sigma",
                           "quantile", "mean * 3 sigma", "quantile x"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_robust(text), Contains("mean + 3 sigma"));
  }
  CHECK_THROWS_WITH(parse_robust("quantile 0.9999"), Contains("must be between 0.001 and 0.999"));
  const std::string still =
      "[machine]\n[machine.parameters.b]\ndefault = 1\nlower = 0\nupper = 2\n"
      "[responses.f]\nformula = 'b^2'\n[variables.b]\nlower = 0\nupper = 2\n";
  CHECK_THAT(testing::complaint(still + "[objective]\nminimize = 'f'\nrobust = 'mean'\n"),
             Contains("objective.robust") && Contains("no variation is stated"));
  CHECK_THAT(testing::complaint(still + "[objective]\nminimize = 'f'\n[[constraints]]\n"
                                        "response = 'f'\nupper = 1\nreliability = 0.9\n"),
             Contains("reliability") && Contains("no variation is stated"));
}

TEST_CASE("Mean and deviation of a linear response are the closed form", "[variation]") {
  // f = 3 b + c: the mean is 3 b + c, the deviation 0.6.
  const optim::Function f = objective_of("3 * b + c", "mean + 3 sigma");
  const std::vector<double> x{1.5, 0.5};
  std::vector<double> g(2), h(3);
  CHECK(f.hessian(x, g, h) == Approx(5 + 1.8).epsilon(0.03));
  CHECK(g[0] == Approx(3).epsilon(1e-9));
  CHECK(g[1] == Approx(1).epsilon(1e-9));
  for (const double bend : h) CHECK(bend == Approx(0).margin(1e-9));
  const optim::Function q = objective_of("3 * b + c", "quantile 0.9");
  CHECK(q.value(x) == Approx(5 + 0.6 * normal_quantile(0.9)).epsilon(0.01));
}

TEST_CASE("Derivatives of robust numbers are those of differences", "[variation]") {
  for (const char* robust : {"mean", "mean + 3 sigma", "mean - 1.5 sigma", "quantile 0.9"}) {
    const optim::Function f = objective_of("exp(0.3 * b) * c^2 + sin(b + c)", robust);
    for (const auto& x : std::vector<std::vector<double>>{{1, 2}, {-2, 0.7}, {0.3, -1.4}}) {
      INFO(robust << " at " << x[0] << ", " << x[1]);
      std::vector<double> g(2), h(3), only(2);
      const double value = f.hessian(x, g, h);
      CHECK(f.value(x) == Approx(value).epsilon(1e-13));
      CHECK(f.gradient(x, only) == Approx(value).epsilon(1e-13));
      for (std::size_t i = 0; i < 2; ++i) {
        constexpr double kStep = 1e-5;
        std::vector<double> up = x, down = x, g_up(2), g_down(2);
        up[i] += kStep;
        down[i] -= kStep;
        const double rise = f.gradient(up, g_up) - f.gradient(down, g_down);
        CHECK(only[i] == Approx(g[i]).epsilon(1e-12));
        CHECK(g[i] == Approx(rise / (2 * kStep)).epsilon(1e-6).margin(1e-8));
        for (std::size_t k = 0; k <= i; ++k) {
          const double bend = (g_up[k] - g_down[k]) / (2 * kStep);
          CHECK(h[optim::packed(i, k)] == Approx(bend).epsilon(1e-5).margin(1e-6));
        }
      }
    }
  }
}

TEST_CASE("What manufacture does not change has no reliability", "[variation]") {
  CHECK_THAT(testing::complaint(machine("c",
                                        "[objective]\nminimize = 'f'\n[[constraints]]\n"
                                        "response = 'f'\nlower = 0\nreliability = 0.9\n")),
             Contains("reliability") && Contains("no variation"));
  CHECK_THAT(testing::complaint(machine("c", "[objective]\nminimize = 'f'\nrobust = 'mean'\n")),
             Contains("robust") && Contains("no variation"));
}

TEST_CASE("A limit on a parameter may have a reliability", "[variation]") {
  // b >= 1 for 90 % of all parts: b = 1 + 0.2 * 1.2816.
  const BoundProblem bound(
      read(machine("b",
                   "[objective]\nminimize = 'f'\nrobust = 'mean'\n"
                   "[[constraints]]\nresponse = 'b'\nlower = 1\nreliability = 0.9\n")));
  const auto found = optim::optimise(bound.space(), {});
  CHECK(found.found.x[0] == Approx(1 + 0.2 * normal_quantile(0.9)).margin(0.02));
}

TEST_CASE("A limit with a reliability leaves out the parts that it may", "[variation]") {
  // c - b >= 0 for 90 % of all parts: c = b + 0.2 * 1.2816; b is held at 1 or above.
  const std::string text =
      machine("c - b",
              "[responses.least]\nformula = 'c'\n[responses.own]\nformula = 'b'\n"
              "[objective]\nminimize = 'least'\n"
              "[[constraints]]\nresponse = 'f'\nlower = 0\nreliability = 0.9\n"
              "[[constraints]]\nresponse = 'own'\nlower = 1\nreliability = 0.5\n");
  const BoundProblem bound(read(text));
  const auto found = optim::optimise(bound.space(), {});
  INFO(found.found.assessment.reason);
  CHECK(found.found.assessment.verdict == optim::Verdict::Feasible);  // an estimate, no proof
  CHECK(found.found.x[1] - found.found.x[0] == Approx(0.2 * normal_quantile(0.9)).margin(0.02));
  CHECK(found.found.x[0] == Approx(1).margin(0.01));
  const ProblemStatement design = bound.at(found.options, found.found.x);
  ToleranceOptions options;
  options.samples = 50000;
  const ToleranceAnswer answer =
      tolerance_of(varied_design(design, variations_of(design)), options);
  REQUIRE(answer.yield);
  CHECK(answer.yield->by_limit[0] == Approx(0.1).margin(0.02));
  CHECK(answer.yield->by_limit[1] == Approx(0.5).margin(0.03));
}

}  // namespace camlaw::problems::robust_test
