// SPDX-License-Identifier: MIT
#include <atomic>
#include <catch2/catch.hpp>
#include <random>

#include "optim/search/plan.h"
#include "optim/solvers/solver.h"
#include "tests/optim/search/search_problems.h"

/// Linear programs.
namespace camlaw::optim::clp_test {
namespace {

using namespace search_tests;

/// a . u of all variables.
Function combination(std::vector<double> a) {
  std::vector<std::size_t> inputs;
  for (std::size_t i = 0; i < a.size(); ++i) inputs.push_back(i);
  return sum_of(std::move(inputs), std::move(a));
}

Row row(std::vector<double> a, double lower, double upper) {
  return {combination(std::move(a)), lower, upper, 1, {}};
}

Solution solved(const Program& program, const SolverOptions& options = {},
                const WarmStart* warm = nullptr) {
  return find_solver("clp").solve(program, options, warm);
}

/// The largest entry of what the gradients weighted with the multipliers add up to.
double unbalanced(const Program& program, const Solution& s) {
  std::vector<double> total(program.variables()), one(program.variables());
  program.gradient(s.y, total);
  for (std::size_t r = 0; r < program.rows(); ++r) {
    program.row_gradient(r, s.y, one);
    for (std::size_t i = 0; i < one.size(); ++i) total[i] += s.rows[r] * one[i];
  }
  double worst = 0;
  for (std::size_t i = 0; i < total.size(); ++i) {
    worst = std::max(worst, std::abs(total[i] - s.lower[i] + s.upper[i]));
  }
  return worst;
}

/// Hillier and Lieberman, Introduction to Operations Research, "Wyndor Glass Co.": the most of
/// 3 x + 5 y is 36 at (2, 6), its shadow prices are 0, 3/2 and 1.
Program wyndor() {
  return {{{0, kInfinity, 0, 1}, {0, kInfinity, 0, 2}},
          combination({3, 5}),
          -1,
          1,
          {row({1, 0}, -kInfinity, 4), row({0, 2}, -kInfinity, 12), row({3, 2}, -kInfinity, 18)}};
}

}  // namespace

TEST_CASE("a textbook's linear program has its optimum and its shadow prices", "[solvers]") {
  const Program program = wyndor();
  const Solution s = solved(program);
  CHECK(s.status == Status::Solved);
  const auto x = program.design(s.y);
  CHECK(x[0] == Approx(2));
  CHECK(x[1] == Approx(6));
  CHECK(program.unscaled_objective(program.objective(s.y)) == Approx(36));
  CHECK(s.rows[0] == Approx(0).margin(1e-12));
  CHECK(s.rows[1] == Approx(1.5));
  CHECK(s.rows[2] == Approx(1));
  CHECK(unbalanced(program, s) < 1e-12);
}

TEST_CASE("a linear program goes on from an earlier answer", "[solvers]") {
  const Program program = wyndor();
  const Solution first = solved(program);
  const WarmStart warm{first.y, first.rows, first.lower, first.upper};
  const Solution again = solved(program, {}, &warm);
  CHECK(again.status == Status::Solved);
  CHECK(again.y == first.y);
  CHECK(again.iterations <= first.iterations);
}

TEST_CASE("linear programs without an answer say so", "[solvers]") {
  const std::vector<ProgramColumn> columns{{0, kInfinity, 0, 1}, {0, kInfinity, 0, 1}};
  const Program contradiction{columns, combination({1, 1}), 1, 1, {row({1, 1}, -kInfinity, -1)}};
  CHECK(solved(contradiction).status == Status::Infeasible);
  const Program endless{columns, combination({1, 1}), -1, 1, {row({1, -1}, -1, 1)}};
  CHECK(solved(endless).status == Status::Unbounded);
}

TEST_CASE("what is not linear is refused", "[solvers]") {
  Problem problem = bowl();
  CHECK(optimise(problem, {.solver = "clp"}).found.assessment.reason ==
        "clp takes only linear problems, and this one is not known to be linear");
  problem.objectives = {least(sum())};
  problem.constraints = {at_most(
      "circle", convex({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }), 1)};
  CHECK(optimise(problem, {.solver = "clp"}).found.assessment.verdict == Verdict::Failed);
  CHECK(plan(problem, "auto").solvers.front()->name() == "slsqp");
}

TEST_CASE("random linear programs have the optimum that Ipopt finds", "[solvers]") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t n = 2 + static_cast<std::size_t>(trial) % 7;
    const auto some = [&] {
      std::vector<double> a(n);
      for (double& value : a) value = unit(random);
      return a;
    };
    std::vector<ProgramColumn> columns;
    std::vector<double> inside;  // meets every row, so that there is an answer
    for (std::size_t i = 0; i < n; ++i) {
      const double lower = 3 * unit(random);
      columns.push_back({lower, lower + 4, lower + 1, 0.5 + std::abs(unit(random))});
      inside.push_back(lower + 2 + unit(random));
    }
    std::vector<Row> rows;
    for (int r = 0; r < 9; ++r) {
      const std::vector<double> a = some();
      double there = 0;
      for (std::size_t i = 0; i < n; ++i) there += a[i] * inside[i];
      const double room = r == 0 ? 0 : std::abs(unit(random));
      rows.push_back(
          row(a, r % 3 == 1 ? -kInfinity : there - room, r % 3 == 2 ? kInfinity : there + room));
    }
    const Program program{columns, combination(some()), trial % 2 == 0 ? 1.0 : -1.0, 0.7, rows};
    const Solution s = solved(program), other = find_solver("ipopt").solve(program, {});
    INFO(trial << ": " << s.message << "; " << other.message);
    REQUIRE(s.status == Status::Solved);
    REQUIRE(other.status == Status::Solved);
    CHECK(program.objective(s.y) == Approx(program.objective(other.y)).margin(1e-6));
    CHECK(unbalanced(program, s) < 1e-8);
    for (std::size_t r = 0; r < program.rows(); ++r) {
      CHECK(program.row(r, s.y) <= program.row_upper()[r] + 1e-8);
      CHECK(program.row(r, s.y) >= program.row_lower()[r] - 1e-8);
    }
  }
}

TEST_CASE("a linear program ends on a request", "[solvers]") {
  const std::atomic<bool> stop{true};
  CHECK(solved(wyndor(), {.stop = &stop}).status == Status::Stopped);
}

}  // namespace camlaw::optim::clp_test
