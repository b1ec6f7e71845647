// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "optim/search/exchange.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::back_ends_test {

using namespace search_tests;

TEST_CASE("equal seeds give equal bits, with every method that draws numbers", "[optimise]") {
  for (const std::string solver : {"auto", "crs2", "isres", "esch", "mlsl", "direct-l"}) {
    INFO(solver);
    Problem problem = two_valleys();
    problem.constraints = {at_most("sum", sum(), 0.5)};
    const OptimiseOptions options{.solver = solver, .seed = 7, .max_evaluations = 2000};
    const Optimum one = optimise(problem, options), two = optimise(problem, options);
    CHECK(same_bits(numbers(one), numbers(two)));
    CHECK(one.found.evaluations == two.found.evaluations);
    CHECK(one.found.iterations == two.found.iterations);
    CHECK(one.found.agreed == two.found.agreed);
  }
}

namespace {

/// Runs a back end on a problem with its optimum known; what it refuses it must refuse in words.
void check_back_end(const std::string& name, const Problem& problem, double optimum) {
  INFO(name << " on " << problem.name);
  const Point start = problem.start();
  const auto refused = refusal(problem, scales(problem, start), start, find_solver(name));
  const Found found =
      optimise(problem, {.solver = name, .starts = 1, .max_evaluations = 3000}).found;
  if (refused) {
    CHECK(found.assessment.verdict == Verdict::Failed);
    CHECK(found.assessment.reason == *refused);
    CHECK(contains(*refused, name));
    CHECK(found.x.empty());
    return;
  }
  // Methods without derivatives come near; whether it is near enough the verdict says.
  CHECK(is_feasible(found.assessment));
  CHECK(found.assessment.verdict != Verdict::Failed);
  CHECK(found.assessment.objective.value == Approx(optimum).epsilon(1e-4));
  if (found.assessment.verdict == Verdict::Certified) {
    CHECK(found.assessment.objective.value == Approx(optimum).epsilon(1e-6));
  }
  const std::set<std::string> exact{"ipopt", "slsqp", "lbfgs", "auglag-lbfgs", "crs2", "isres"};
  if (exact.contains(name)) CHECK(found.assessment.verdict == Verdict::Certified);
}

}  // namespace

TEST_CASE("every back end solves what it accepts and refuses the rest in words", "[optimise]") {
  std::vector<Problem> problems(4, bowl());
  problems[0].name = "a box";
  problems[1].name = "a limit";
  problems[1].constraints = {at_least("sum", sum(), 1)};
  problems[2].name = "an equation";
  problems[2].constraints = {equal("sum", sum(), 1)};
  problems[3].name = "no box";
  problems[3].variables[0].upper = kInfinity;
  const Point optima{-11.0 / 14, -0.625, -0.625, -11.0 / 14};
  for (const std::string& name : solver_names()) {
    for (std::size_t i = 0; i < problems.size(); ++i) check_back_end(name, problems[i], optima[i]);
  }
}

TEST_CASE("some back ends refuse, and none drops a limit", "[optimise]") {
  Problem limited = bowl();
  limited.constraints = {at_least("sum", sum(), 1)};
  CHECK(optimise(limited, {.solver = "lbfgs"}).found.assessment.reason ==
        "lbfgs takes no constraints besides bounds on the variables");
  limited.constraints = {equal("sum", sum(), 1)};
  CHECK(optimise(limited, {.solver = "mma"}).found.assessment.reason == "mma takes no equations");
  limited.variables[0].upper = kInfinity;
  CHECK(optimise(limited, {.solver = "isres"}).found.assessment.reason ==
        "isres searches the whole box: each variable needs a lower and an upper bound");
}

TEST_CASE("progress is reported in the problem's units and sign", "[optimise]") {
  for (const char* name : {"ipopt", "slsqp"}) {
    for (const bool maximise : {false, true}) {
      INFO(name << (maximise ? ", to maximise" : ""));
      int calls = 0;
      double last = kNan;
      OptimiseOptions options{.solver = name};
      options.progress = [&](const Progress& p) { ++calls, last = p.objective; };
      Problem problem = bowl();
      if (maximise) {
        problem.objectives = {most(function<Interval>(
            {0, 1}, [](const auto& u) { return 50.0 - square(u[0] - 1.0) - square(u[1] + 0.5); },
            Shape::Concave))};
      }
      const Found found = optimise(problem, options).found;
      CHECK(calls > 1);
      CHECK(last == Approx(found.assessment.objective.value).epsilon(1e-6));
    }
  }
}

}  // namespace camlaw::optim::back_ends_test
