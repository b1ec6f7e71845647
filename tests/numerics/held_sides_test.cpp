// SPDX-License-Identifier: MIT
#include "numerics/linear/held_sides.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace camlaw::optim::held_sides_test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr Eigen::Index kCount = 400;

/// A string of beads held by springs, 1 each, pulled down by `pull` each, above a floor at -1; from
/// bead to bead it falls or rises by no more than 0.12. From an end it has the slope p (k - i) to
/// the k-th bead, which touches the floor: k = sqrt(2 / p) to within one. At p = 0.01 that is 14,
/// and the first slopes are held.
QuadraticProgram string_above_floor(double pull) {
  QuadraticProgram program;
  program.cost = Eigen::VectorXd::Constant(kCount, pull);
  program.curvature.resize(kCount, kCount);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    program.curvature.insert(i, i) = 2;
    if (i + 1 < kCount) program.curvature.insert(i + 1, i) = -1;
  }
  program.rows.resize(kCount - 1, kCount);
  for (Eigen::Index i = 0; i + 1 < kCount; ++i) {
    program.rows.insert(i, i) = -1;
    program.rows.insert(i, i + 1) = 1;
  }
  program.row_lower = Eigen::VectorXd::Constant(kCount - 1, -0.12);
  program.row_upper = Eigen::VectorXd::Constant(kCount - 1, 0.12);
  program.lower = Eigen::VectorXd::Constant(kCount, -1);
  program.upper = Eigen::VectorXd::Constant(kCount, 1);
  return program;
}

/// The largest of what is left of the columns' conditions.
double left_of_columns(const QuadraticProgram& program, const InteriorSolution& found) {
  const Eigen::VectorXd left = program.cost +
                               program.curvature.selfadjointView<Eigen::Lower>() * found.y +
                               program.rows.transpose() * found.row_multipliers -
                               found.lower_multipliers + found.upper_multipliers;
  return left.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("what holds a solution gives it again, to rounding", "[held-sides]") {
  const QuadraticProgram program = string_above_floor(0.01);
  const InteriorSolution by_path = solve_by_interior_point(program, Eigen::VectorXd::Zero(kCount));
  REQUIRE(by_path.end == InteriorEnd::Optimal);
  const HeldSides held = held_sides(program, by_path);
  CHECK(held.variables[kCount / 2] == -1);
  CHECK(held.variables[0] == 0);
  CHECK(held.rows[0] == -1);
  CHECK(held.rows[kCount - 2] == 1);
  const auto found = solve_from_held_sides(program, held);
  REQUIRE(found);
  CHECK(found->end == InteriorEnd::Optimal);
  CHECK(found->iterations == 1);
  CHECK((found->y - by_path.y).cwiseAbs().maxCoeff() < 1e-7);
  CHECK((found->row_multipliers - by_path.row_multipliers).cwiseAbs().maxCoeff() < 1e-6);
  CHECK(left_of_columns(program, *found) < 1e-13);
  CHECK(found->y[kCount / 2] == -1);
}

TEST_CASE("sides of a program that differs a little are put right", "[held-sides]") {
  const QuadraticProgram before = string_above_floor(0.01), after = string_above_floor(0.0094);
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(kCount);
  const HeldSides held = held_sides(before, solve_by_interior_point(before, start));
  const InteriorSolution by_path = solve_by_interior_point(after, start);
  const HeldSides own = held_sides(after, by_path);
  REQUIRE((own.rows != held.rows || own.variables != held.variables));
  const auto found = solve_from_held_sides(after, held);
  REQUIRE(found);
  CHECK(found->iterations > 1);
  CHECK((found->y - by_path.y).cwiseAbs().maxCoeff() < 1e-7);
  CHECK(left_of_columns(after, *found) < 1e-13);
}

TEST_CASE("sides of quite another program give nothing", "[held-sides]") {
  const QuadraticProgram program = string_above_floor(0.01);
  HeldSides none{std::vector<signed char>(kCount - 1, 0), std::vector<signed char>(kCount, 0)};
  CHECK_FALSE(solve_from_held_sides(program, none));
  HeldSides all{std::vector<signed char>(kCount - 1, 1), std::vector<signed char>(kCount, 1)};
  CHECK_FALSE(solve_from_held_sides(program, all));
}

TEST_CASE("rows that join all variables are not local", "[held-sides]") {
  QuadraticProgram program = string_above_floor(0.01);
  CHECK(has_local_rows(program));
  program.rows.resize(1, kCount);
  for (Eigen::Index i = 0; i < kCount; ++i) program.rows.insert(0, i) = 1;
  program.row_lower = Eigen::VectorXd::Constant(1, -kInfinite);
  program.row_upper = Eigen::VectorXd::Constant(1, 1);
  CHECK_FALSE(has_local_rows(program));
  HeldSides held{{0}, std::vector<signed char>(kCount, -1)};
  CHECK_FALSE(solve_from_held_sides(program, held));
}

TEST_CASE("a program begins on the way of one that differs little", "[held-sides]") {
  const QuadraticProgram before = string_above_floor(0.01), after = string_above_floor(0.0101);
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(kCount);
  const InteriorSolution way = solve_by_interior_point(before, start, {.keeps_stages = true});
  REQUIRE(way.stages.size() > 3);
  for (std::size_t k = 1; k < way.stages.size(); ++k)
    CHECK(way.stages[k].gap < 0.3 * way.stages[k - 1].gap);
  const InteriorSolution cold = solve_by_interior_point(after, start);
  const InteriorSolution warm = solve_by_interior_point(after, start, {.stage = &way.stages[2]});
  CHECK(warm.end == InteriorEnd::Optimal);
  CHECK(warm.iterations < cold.iterations);
  CHECK((warm.y - cold.y).cwiseAbs().maxCoeff() < 1e-7);
  CHECK(cold.stages.empty());
}

TEST_CASE("a path of local rows ends at the solution of what holds", "[held-sides]") {
  const QuadraticProgram program = string_above_floor(0.01);
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(kCount);
  const InteriorSolution found = solve_by_interior_point(program, start, {.settles = true});
  CHECK(found.end == InteriorEnd::Optimal);
  CHECK(left_of_columns(program, found) < 1e-13);
  CHECK(found.y[kCount / 2] == -1);
  CHECK(found.lower_multipliers[0] == 0);
}

}  // namespace camlaw::optim::held_sides_test
