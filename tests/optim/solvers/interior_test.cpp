// SPDX-License-Identifier: MIT
#include "optim/solvers/interior.h"

#include <atomic>
#include <catch2/catch.hpp>

#include "optim/search/plan.h"
#include "tests/optim/search/search_problems.h"

/// Linear programs by the interior-point method.
namespace camlaw::optim::interior_test {
namespace {

using namespace search_tests;

/// The most of 3 x + 5 y is 36 at (2, 6), the shadow prices are 0, 3/2 and 1 (Hillier and
/// Lieberman, "Wyndor Glass Co.").
Program wyndor() {
  return {{{0, kInfinity, 0, 1}, {0, kInfinity, 0, 2}},
          sum_of({0, 1}, {3, 5}),
          -1,
          1,
          {{sum_of({0}, {1}), -kInfinity, 4, 1, {}},
           {sum_of({1}, {2}), -kInfinity, 12, 1, {}},
           {sum_of({0, 1}, {3, 2}), -kInfinity, 18, 1, {}}}};
}

/// Each step from one of n variables to the next is at most 1 up; the first is 0 and their sum is
/// to be the most.
Program staircase(std::size_t n) {
  std::vector<ProgramColumn> columns(n, {-1000, 1000, 0.25, 1});
  columns[0].upper = 0;
  std::vector<Row> rows;
  std::vector<std::size_t> all(n);
  for (std::size_t i = 0; i < n; ++i) all[i] = i;
  for (std::size_t i = 0; i + 1 < n; ++i)
    rows.push_back({sum_of({i, i + 1}, {-1, 1}), -kInfinity, 1, 1, {}});
  return {columns, sum_of(all, std::vector<double>(n, 1.0)), -1, static_cast<double>(n), rows};
}

}  // namespace

TEST_CASE("the interior-point method finds optimum and shadow prices", "[interior]") {
  const Program program = wyndor();
  const Solution s = interior_solver().solve(program, {});
  REQUIRE(s.status == Status::Solved);
  const std::vector<double> x = program.design(s.y);
  CHECK(x[0] == Approx(2).epsilon(1e-7));
  CHECK(x[1] == Approx(6).epsilon(1e-7));
  CHECK(s.rows[0] == Approx(0).margin(1e-7));
  CHECK(s.rows[1] == Approx(1.5).epsilon(1e-6));
  CHECK(s.rows[2] == Approx(1).epsilon(1e-6));
}

TEST_CASE("local rows in many variables take few iterations", "[interior]") {
  const Program program = staircase(2000);
  const Solution s = interior_solver().solve(program, {});
  REQUIRE(s.status == Status::Solved);
  CHECK(s.iterations < 60);
  const std::vector<double> x = program.design(s.y);
  for (const std::size_t i : {0, 1, 1000, 1999}) {
    const double highest = std::min(static_cast<double>(i), 1000.0);
    CHECK(x[i] == Approx(highest).margin(1e-4));
  }
}

TEST_CASE("the interior-point method says what it does not take", "[interior]") {
  const Function bent = function<Interval>({0}, [](const auto& u) { return u[0] * u[0]; });
  const Program nonlinear({{0, 1, 0.5, 1}}, bent, 1, 1, {});
  CHECK(interior_solver().refusal(nonlinear).has_value());
  CHECK(interior_solver().solve(nonlinear, {}).status == Status::Failed);
  std::atomic<bool> stop = true;
  SolverOptions options;
  options.stop = &stop;
  CHECK(interior_solver().solve(staircase(50), options).status == Status::Stopped);
}

TEST_CASE("rows that contradict one another, and no bound at all, are not called solved",
          "[interior]") {
  const Program contradictory(
      {{-10, 10, 0, 1}}, sum_of({0}, {1}), 1, 1,
      {{sum_of({0}, {1}), 2, kInfinity, 1, {}}, {sum_of({0}, {1}), -kInfinity, 1, 1, {}}});
  CHECK(interior_solver().solve(contradictory, {}).status != Status::Solved);
  const Program open({{-kInfinity, kInfinity, 0, 1}}, sum_of({0}, {1}), 1, 1,
                     {{sum_of({0}, {1}), -kInfinity, 1, 1, {}}});
  CHECK(interior_solver().solve(open, {}).status != Status::Solved);
}

TEST_CASE("equations hold, and have their prices", "[interior]") {
  // The mean of 100 numbers within [0, 1 + i] is 10 where their sum by weights is least: by the
  // weights' order the first are full, of a price that is the weight of the last.
  std::vector<ProgramColumn> columns;
  std::vector<std::size_t> all;
  std::vector<double> weights, ones;
  for (std::size_t i = 0; i < 100; ++i) {
    columns.push_back({0, 1.0 + static_cast<double>(i), 0.5, 1});
    all.push_back(i);
    weights.push_back(1 + static_cast<double>(i) / 100);
    ones.push_back(1);
  }
  const Program program(columns, sum_of(all, weights), 1, 1,
                        {{sum_of(all, ones), 1000, 1000, 1, {}}});
  const Solution s = interior_solver().solve(program, {});
  REQUIRE(s.status == Status::Solved);
  const std::vector<double> x = program.design(s.y);
  // 1 + 2 + ... + 44 = 990: the 45th takes the last ten.
  CHECK(x[43] == Approx(44).epsilon(1e-7));
  CHECK(x[44] == Approx(10).epsilon(1e-7));
  CHECK(x[45] == Approx(0).margin(1e-7));
  CHECK(s.rows[0] == Approx(-1.44).epsilon(1e-7));
}

TEST_CASE("without inequalities there is nothing to step by", "[interior]") {
  const Program program({{-kInfinity, kInfinity, 0, 1}}, sum_of({0}, {1}), 1, 1,
                        {{sum_of({0}, {1}), 2, 2, 1, {}}});
  CHECK(interior_solver().solve(program, {}).status == Status::Stalled);
}

TEST_CASE("linear problems go to the interior-point method, of few variables to clp first",
          "[interior]") {
  Problem problem;
  for (int i = 0; i < 31; ++i) problem.variables.push_back({.name = "x", .lower = 0, .upper = 1});
  problem.objectives = {{{"sum", "1", sum_of({0}, {1})}}};
  problem.constraints = {{{"first", "1", sum_of({0}, {1})}, 0.5, 0.5}};
  const auto names = [&] {
    std::vector<std::string> result;
    for (const Solver* solver : plan(problem, "auto").solvers) result.push_back(solver->name());
    return result;
  };
  CHECK(names() == std::vector<std::string>{"interior", "clp", "ipopt"});
  problem.variables.resize(30);  // of so few, slsqp's dense matrices do no harm
  CHECK(names() == std::vector<std::string>{"clp", "interior", "ipopt", "slsqp"});
}

}  // namespace camlaw::optim::interior_test
