// SPDX-License-Identifier: MIT
#include "numerics/linear/quadratic_program.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace camlaw::optim::quadratic_program_test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A symmetric matrix of which the lower triangle is stored.
Eigen::SparseMatrix<double> lower_triangle(const Eigen::MatrixXd& A) {
  return Eigen::MatrixXd(A.triangularView<Eigen::Lower>()).sparseView();
}

}  // namespace

TEST_CASE("a convex quadratic program: the point of a half-plane nearest to another",
          "[quadratic-program]") {
  // (1, 1) is nearest to (3, 3) where x + y <= 2; moving the bound by 1 moves it by (1/2, 1/2), of
  // half the squared distance 4 the slope is -2.
  QuadraticProgram program;
  program.cost = Eigen::Vector2d(-3, -3);
  program.curvature = lower_triangle(Eigen::Matrix2d::Identity());
  program.rows.resize(1, 2);
  program.rows.insert(0, 0) = 1;
  program.rows.insert(0, 1) = 1;
  program.row_lower = Eigen::VectorXd::Constant(1, -kInfinite);
  program.row_upper = Eigen::VectorXd::Constant(1, 2);
  program.lower = Eigen::Vector2d(-10, -10);
  program.upper = Eigen::Vector2d(10, 10);
  const InteriorSolution found = solve_by_interior_point(program, Eigen::Vector2d(5, -4));
  REQUIRE(found.end == InteriorEnd::Optimal);
  CHECK(found.y[0] == Approx(1).epsilon(1e-7));
  CHECK(found.y[1] == Approx(1).epsilon(1e-7));
  CHECK(found.row_multipliers[0] == Approx(2).epsilon(1e-7));
}

TEST_CASE("a convex quadratic program of many variables meets the conditions of optimality",
          "[quadratic-program]") {
  // A string of beads held by springs, 1 each, pulled down by 0.01 each, above a floor at -1.
  constexpr Eigen::Index kCount = 400;
  Eigen::MatrixXd springs = Eigen::MatrixXd::Zero(kCount, kCount);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    springs(i, i) = 2;
    if (i > 0) springs(i, i - 1) = springs(i - 1, i) = -1;
  }
  QuadraticProgram program;
  program.cost = Eigen::VectorXd::Constant(kCount, 0.01);
  program.curvature = lower_triangle(springs);
  program.rows.resize(0, kCount);
  program.row_lower = program.row_upper = Eigen::VectorXd(0);
  program.lower = Eigen::VectorXd::Constant(kCount, -1);
  program.upper = Eigen::VectorXd::Constant(kCount, 1);
  const InteriorSolution found = solve_by_interior_point(program, Eigen::VectorXd::Zero(kCount));
  REQUIRE(found.end == InteriorEnd::Optimal);
  const Eigen::VectorXd left =
      program.cost + springs * found.y - found.lower_multipliers + found.upper_multipliers;
  CHECK(left.cwiseAbs().maxCoeff() < 1e-8);
  // From an end to the floor the string is the parabola that touches it there: 0.005 n^2 = 1.
  const double reach = std::sqrt(1 / 0.005);
  CHECK(found.y[static_cast<Eigen::Index>(reach) + 2] == Approx(-1).margin(1e-6));
  CHECK(found.y[static_cast<Eigen::Index>(reach) - 4] > -1 + 1e-3);
  CHECK(found.lower_multipliers[kCount / 2] == Approx(0.01).epsilon(1e-6));
}

}  // namespace camlaw::optim::quadratic_program_test
