// SPDX-License-Identifier: MIT
// Multipliers that a method for linear programs tells: of many variables they are what the verdict
// goes by, as far as they hold.
#include "optim/search/told.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "optim/search/optimise.h"
#include "optim/verdict/verdict.h"
#include "tests/optim/search/search_problems.h"

namespace camlaw::optim::told_test {
namespace {

using namespace search_tests;

std::vector<std::size_t> first(std::size_t n) {
  std::vector<std::size_t> all(n);
  for (std::size_t i = 0; i < n; ++i) all[i] = i;
  return all;
}

/// n variables p1, p2, ... in [0, 1].
std::vector<Variable> many(std::size_t n) {
  std::vector<Variable> result;
  for (std::size_t i = 0; i < n; ++i) {
    result.push_back({.name = "p" + std::to_string(i + 1), .lower = 0, .upper = 1, .start = 0.5});
  }
  return result;
}

/// Hillier and Lieberman's "Wyndor Glass Co.": the most of 3 x + 5 y is 36 at (2, 6), the shadow
/// prices are 0, 3/2 and 1; with variables beside that cost 2 each.
Problem padded_wyndor(Sense sense) {
  constexpr std::size_t kBeside = 80;
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 100, .start = 0},
                       {.name = "y", .lower = 0, .upper = 100, .start = 2}};
  std::vector<double> weights{3, 5};
  for (const Variable& v : many(kBeside)) {
    problem.variables.push_back(v);
    weights.push_back(-2);
  }
  if (sense == Sense::Minimize) {
    for (double& weight : weights) weight = -weight;
  }
  problem.objectives = {
      {{"profit", "1", sum_of(first(kBeside + 2), weights)}, sense, Part::Value, {}}};
  problem.constraints = {{{"first", "1", sum_of({0}, {1})}, {}, 4.0},
                         {{"second", "1", sum_of({1}, {-2})}, -12.0, {}},
                         {{"third", "1", sum_of({0, 1}, {3, 2})}, -50.0, 18.0}};
  return problem;
}

}  // namespace

TEST_CASE("told multipliers are the prices of limits and of variables' bounds", "[told]") {
  const Sense sense = GENERATE(Sense::Maximize, Sense::Minimize);
  const Problem problem = padded_wyndor(sense);
  const Found found = optimise(problem).found;
  const Assessment& a = found.assessment;
  INFO(a.reason);
  CHECK(found.solver == "interior");
  CHECK(a.verdict == Verdict::Certified);
  CHECK(a.global.has_value());
  CHECK(a.limits[0].multiplier == Approx(0).margin(1e-6));
  CHECK(a.limits[1].multiplier == Approx(1.5).epsilon(1e-6));
  CHECK(a.limits[2].multiplier == Approx(1).epsilon(1e-6));
  CHECK(a.variables[0].multiplier == Approx(0).margin(1e-6));
  for (const std::size_t i : {std::size_t{2}, problem.variables.size() - 1}) {
    CHECK(a.variables[i].at_lower);
    CHECK(a.variables[i].multiplier == Approx(2).epsilon(1e-6));
  }
  CHECK(std::find(a.active.begin(), a.active.end(), "first") == a.active.end());
}

TEST_CASE("the price of an equation is what its value adds to the objective", "[told]") {
  // Of 100 numbers within [0, 1], ever dearer, that add up to 40.5 the first forty are whole and
  // the next is a half: one more costs what that one does.
  Problem problem;
  problem.variables = many(100);
  std::vector<double> weights, ones;
  for (std::size_t i = 0; i < 100; ++i) {
    weights.push_back(1 + static_cast<double>(i) / 100);
    ones.push_back(1);
  }
  problem.objectives = {{{"cost", "1", sum_of(first(100), weights)}}};
  problem.constraints = {{{"sum", "1", sum_of(first(100), ones)}, 40.5, 40.5}};
  const Found found = optimise(problem).found;
  INFO(found.assessment.reason);
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.x[39] == Approx(1).epsilon(1e-6));
  CHECK(found.x[40] == Approx(0.5).epsilon(1e-6));
  CHECK(found.assessment.limits[0].multiplier == Approx(1.4).epsilon(1e-6));
}

TEST_CASE("what cannot be is blamed together with the bounds that forbid it", "[told]") {
  Problem problem;
  problem.variables = many(80);
  problem.objectives = {{{"one", "1", sum_of({0}, {1})}}};
  problem.constraints = {{{"sum", "1", sum_of(first(80), std::vector<double>(80, 1.0))}, 81.0, {}}};
  const Assessment a = optimise(problem).found.assessment;
  INFO(a.reason);
  CHECK(a.verdict == Verdict::Infeasible);
  CHECK(a.global.has_value());
  const auto blames = [&](const char* name) {
    return std::find(a.blamed.begin(), a.blamed.end(), name) != a.blamed.end();
  };
  CHECK(blames("sum"));
  CHECK(blames("upper bound of p1"));
  CHECK(blames("upper bound of p80"));
}

TEST_CASE("what is told wrongly does not certify a design", "[told]") {
  const Problem problem = padded_wyndor(Sense::Maximize);
  const std::vector<double> best = optimise(problem).found.x;
  const Scales own = scales(problem, best);
  std::vector<double> worse = best;
  worse[0] = 1.5;  // where the first two limits leave room for more
  const auto judged = [&](std::vector<Push> pushes) {
    return assess(problem, own, worse, true, [pushes] { return pushes; });
  };
  std::vector<Push> pushes = told_at(problem, own, best);
  REQUIRE(!pushes.empty());
  CHECK(judged(pushes).verdict == Verdict::Feasible);
  for (Push& push : pushes) push.sign = -push.sign;
  CHECK(judged(pushes).verdict == Verdict::Feasible);
  for (Push& push : pushes) push.price = -1e3 * push.price;
  CHECK(judged(pushes).verdict == Verdict::Feasible);
  for (Push& push : pushes) push.sign = -1, push.price = 1;
  CHECK(judged(pushes).verdict == Verdict::Feasible);
}

}  // namespace camlaw::optim::told_test
