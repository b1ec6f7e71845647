// SPDX-License-Identifier: MIT
#include "optim/solvers/sequential.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "optim/search/plan.h"
#include "tests/optim/search/search_problems.h"

/// Nonlinear programs by a sequence of convex quadratic ones.
namespace camlaw::optim::sequential_test {
namespace {

using namespace search_tests;

/// A ring of n numbers, neighbours in a circle of radius 1: their sum is the most, n / sqrt(2),
/// where all are 1 / sqrt(2), since two in a circle add up to sqrt(2) at most. Each is in two
/// circles, so that 1 = 2 * price * 2 / sqrt(2).
Program ring(std::size_t n) {
  std::vector<std::size_t> all(n);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < n; ++i) {
    all[i] = i;
    const Function circle =
        function<Interval>({std::min(i, (i + 1) % n), std::max(i, (i + 1) % n)},
                           [](const auto& u) { return square(u[0]) + square(u[1]); });
    rows.push_back({circle, -kInfinity, 1, 1, {}});
  }
  const std::vector<ProgramColumn> columns(n, {-2, 2, 0.1, 1});
  return {columns, sum_of(all, std::vector<double>(n, 1.0)), -1, 1, rows};
}

/// The point outside of the unit circle that is nearest to q = (0.5, 0.2): q / |q|, and the price
/// of the circle in squares is 1 - |q|. The circle's inside is what is left out, so that nothing is
/// convex.
Program outside() {
  const auto distance = function<Interval>(
      {0, 1}, [](const auto& u) { return square(u[0] - 0.5) + square(u[1] - 0.2); }, Shape::Convex);
  const auto circle =
      function<Interval>({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); });
  return {{{-5, 5, 2, 1}, {-5, 5, -1, 1}}, distance, 1, 1, {{circle, 1, kInfinity, 1, {}}}};
}

/// A half, whatever varies.
class Fixed final : public Kernel {
 public:
  double value(std::span<const double>) const override { return 0.5; }
  double gradient(std::span<const double>, std::span<double>) const override { return 0.5; }
  double hessian(std::span<const double>, std::span<double>, std::span<double>) const override {
    return 0.5;
  }
};

}  // namespace

TEST_CASE("a sequence of quadratic programs finds optimum and shadow prices", "[sequential]") {
  constexpr std::size_t kCount = 200;
  const Program program = ring(kCount);
  const Solution s = sequential_solver().solve(program, {});
  REQUIRE(s.status == Status::Solved);
  CHECK(s.iterations < 30);
  for (const double x : program.design(s.y)) CHECK(x == Approx(std::sqrt(0.5)).epsilon(1e-7));
  for (const double price : s.rows) CHECK(price == Approx(std::sqrt(0.125)).epsilon(1e-5));
}

TEST_CASE("a sequence of quadratic programs takes what is not convex", "[sequential]") {
  const Program program = outside();
  const Solution s = sequential_solver().solve(program, {});
  REQUIRE(s.status == Status::Solved);
  const std::vector<double> x = program.design(s.y);
  const double distance = std::hypot(0.5, 0.2);
  // Its last step is 1e-6 long; the steps before were a few times as long each.
  CHECK(x[0] == Approx(0.5 / distance).epsilon(1e-5));
  CHECK(x[1] == Approx(0.2 / distance).epsilon(1e-5));
  CHECK(s.rows[0] == Approx(distance - 1).epsilon(1e-5));
}

TEST_CASE("what no variable moves does not bend a program", "[sequential]") {
  // A place where a curve is fixed gives a row without inputs.
  const Function fixed({}, std::make_shared<Fixed>());
  const Program program{{{-5, 5, 2, 1}}, sum_of({0}, {1}), 1, 1, {{fixed, -kInfinity, 1, 1, {}}}};
  std::vector<double> entries(program.hessian_pattern().size());
  const std::vector<double> y{2}, multipliers{1};
  program.convex_hessian(y, 1, multipliers, entries);
  CHECK(sequential_solver().solve(program, {}).status == Status::Solved);
}

TEST_CASE("a sequence of quadratic programs ends where rows leave no room and have no slope",
          "[sequential]") {
  // x + y within x^2 <= 0: no multiplier holds x = 0. It may end near it, or give up.
  const auto square_of_x = function<Interval>(
      {0}, [](const auto& u) { return square(u[0]); }, Shape::Convex);
  const Program flat{{{-3, 4, 1, 1}, {-2, 7, 1.5, 1}},
                     sum_of({0, 1}, {1, 1}),
                     1,
                     1,
                     {{square_of_x, -kInfinity, 0, 1, {}}}};
  const Solution s = sequential_solver().solve(flat, {.time_limit = 20});
  CHECK(s.status != Status::TimeLimit);
  CHECK(s.status != Status::Infeasible);
  // Kuhn and Tucker's cusp: y <= (1 - x)^3, y >= 0, most x.
  const auto cusp = function<Interval>(
      {0, 1}, [](const auto& u) { return u[1] + square(u[0] - 1.0) * (u[0] - 1.0); });
  const auto height = function<Interval>(
      {1}, [](const auto& u) { return u[0]; }, Shape::Linear);
  const Program tip{{{-3, 4, 0, 1}, {-2, 7, 1.5, 1}},
                    sum_of({0}, {1}),
                    -1,
                    1,
                    {{cusp, -kInfinity, 0, 1, {}}, {height, 0, kInfinity, 1, {}}}};
  CHECK(sequential_solver().solve(tip, {.time_limit = 20}).status != Status::TimeLimit);
}

TEST_CASE("a limit bends a program across its own gradient alone, a peak's place in all directions",
          "[sequential]") {
  // The gradient at (1, 0) is (2, 0), the second derivatives are 2 and 4.
  const auto bowl = function<Interval>(
      {0, 1}, [](const auto& u) { return square(u[0]) + 2.0 * square(u[1]); }, Shape::Convex);
  const std::vector<double> y{1, 0, 0}, multipliers{1};
  const auto entries_of = [&](Row row) {
    const Program program{
        {{-5, 5, 1, 1}, {-5, 5, 0, 1}, {-5, 5, 0, 1}}, sum_of({2}, {1}), 1, 1, {std::move(row)}};
    std::vector<double> entries(program.hessian_pattern().size());
    program.convex_hessian(y, 1, multipliers, entries);
    double along = 0, across = 0;
    for (std::size_t k = 0; k < entries.size(); ++k) {
      if (program.hessian_pattern().rows[k] != program.hessian_pattern().columns[k]) continue;
      (program.hessian_pattern().rows[k] == 0 ? along : across) += entries[k];
    }
    return std::pair(along, across);
  };
  const auto [along, across] = entries_of({bowl, -kInfinity, 1, 1, {}});
  CHECK(along == Approx(0).margin(1e-14));
  CHECK(across == Approx(4));
  const auto [peak_along, peak_across] = entries_of({bowl, -kInfinity, 0, 1, {{2, -1.0}}});
  CHECK(peak_along == Approx(2));
  CHECK(peak_across == Approx(4));
}

TEST_CASE("a sequence of quadratic programs says how it ended", "[sequential]") {
  SECTION("rows that contradict one another") {
    const Program program{
        {{-5, 5, 0.3, 1}, {-5, 5, 0, 1}},
        sum_of({0, 1}, {1, 1}),
        1,
        1,
        {{function<Interval>({0, 1}, [](const auto& u) { return square(u[0]) + square(u[1]); }),
          -kInfinity,
          -1,
          1,
          {}}}};
    CHECK(sequential_solver().solve(program, {}).status == Status::Infeasible);
  }
  SECTION("stopped") {
    std::atomic<bool> stop = true;
    SolverOptions options;
    options.stop = &stop;
    CHECK(sequential_solver().solve(ring(50), options).status == Status::Stopped);
  }
  SECTION("out of iterations") {
    SolverOptions options;
    options.max_iterations = 1;
    CHECK(sequential_solver().solve(ring(50), options).status == Status::IterationLimit);
  }
}

TEST_CASE("problems of many variables that are not linear go to it first", "[sequential]") {
  Problem problem;
  for (std::size_t i = 0; i <= 30; ++i)
    problem.variables.push_back(variable("x" + std::to_string(i), -2, 2, 0.1));
  problem.objectives = {least(sum_of({0}, {1}))};
  problem.constraints = {at_least(
      "circle", function<Interval>({0, 1}, [](const auto& u) { return 1.0 - square(u[0]); }), 0)};
  CHECK(plan(problem, "auto").solvers.front()->name() == "sequential");
  const Found found = optimise(problem).found;
  CHECK(found.assessment.verdict == Verdict::Certified);
  CHECK(found.assessment.objective.value == Approx(-1).epsilon(1e-8));
}

TEST_CASE("a few variables whose bounds lie far apart go to it too", "[sequential]") {
  Problem problem;
  for (std::size_t i = 0; i < 6; ++i) {
    problem.variables.push_back(variable("x" + std::to_string(i), -2, 2, 0.1));
    problem.variables.back().scale = 0.1;
  }
  problem.objectives = {least(function<Interval>({0}, [](const auto& u) { return square(u[0]); }))};
  CHECK(plan(problem, "auto").solvers.front()->name() == "sequential");
  problem.variables.back().scale = 1;  // one of them may be drawn at random
  CHECK(plan(problem, "auto").solvers.front()->name() == "slsqp");
}

}  // namespace camlaw::optim::sequential_test
