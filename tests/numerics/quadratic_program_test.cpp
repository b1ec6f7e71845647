// SPDX-License-Identifier: MIT
#include "numerics/linear/quadratic_program.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "numerics/linear/banded_lu.h"
#include "numerics/linear/newton_system.h"

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

TEST_CASE("a banded matrix with zeros on its diagonal is solved as a full one",
          "[quadratic-program]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> entry(-1, 1);
  constexpr Eigen::Index kSize = 60, kHalf = 4;
  BandedLu banded(kSize, kHalf);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(kSize, kSize);
  std::vector<double> entries(static_cast<std::size_t>(banded.places()), 0.0);
  for (Eigen::Index i = 0; i < kSize; ++i) {
    for (Eigen::Index j = std::max<Eigen::Index>(0, i - kHalf); j <= std::min(kSize - 1, i + kHalf);
         ++j) {
      if (i == j && i % 3 != 0) continue;
      entries[static_cast<std::size_t>(banded.place(i, j))] = full(i, j) = entry(random);
    }
  }
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(kSize, -1, 2);
  REQUIRE(banded.factor(entries));
  CHECK((banded.solve(full * wanted) - wanted).cwiseAbs().maxCoeff() < 1e-10);
  std::fill(entries.begin(), entries.end(), 0.0);
  CHECK_FALSE(banded.factor(entries));
}

TEST_CASE("variables and rows together give the step of the normal equations",
          "[quadratic-program]") {
  // A chain whose second differences are bounded on both sides, with two equations.
  constexpr Eigen::Index kCount = 50;
  QuadraticProgram program;
  program.cost = Eigen::VectorXd::LinSpaced(kCount, -1, 1);
  program.curvature = lower_triangle(Eigen::MatrixXd::Identity(kCount, kCount));
  program.rows.resize(kCount - 2, kCount);
  for (Eigen::Index r = 0; r < kCount - 2; ++r) {
    program.rows.insert(r, r) = 1;
    program.rows.insert(r, r + 1) = -2;
    program.rows.insert(r, r + 2) = 1.5;
  }
  program.row_lower = Eigen::VectorXd::Constant(kCount - 2, -0.1);
  program.row_upper = Eigen::VectorXd::Constant(kCount - 2, 0.2);
  program.row_lower[9] = program.row_upper[9] = 0.05;
  program.row_lower[30] = program.row_upper[30] = 0;
  program.row_lower[20] = -kInfinite;
  program.row_upper[20] = kInfinite;  // says nothing
  program.lower = Eigen::VectorXd::Constant(kCount, -1);
  program.upper = Eigen::VectorXd::Constant(kCount, kInfinite);
  const ProgramSides sides(program);
  const Eigen::Index rows = sides.rows.rows() + kCount;
  CHECK(sides.rows.rows() == kCount - 5);
  const auto normal = normal_equations(sides), augmented = augmented_system(sides);
  REQUIRE(augmented != nullptr);
  const Eigen::VectorXd weights =
      Eigen::VectorXd::LinSpaced(rows, -2, 2).unaryExpr([](double e) { return std::pow(10, e); });
  REQUIRE(normal->factor(weights));
  REQUIRE(augmented->factor(weights));
  const Eigen::VectorXd slope = Eigen::VectorXd::LinSpaced(kCount, 0, 3),
                        push = Eigen::VectorXd::LinSpaced(rows, 1, -1);
  const Eigen::Vector2d demand(0.3, -0.2);
  const NewtonStep one = normal->solve(slope, push, demand),
                   other = augmented->solve(slope, push, demand);
  CHECK((one.y - other.y).cwiseAbs().maxCoeff() < 1e-10);
  CHECK((one.changes - other.changes).cwiseAbs().maxCoeff() < 1e-10);
  CHECK((one.w - other.w).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((sides.equations * other.y - demand).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a linear program that begins near another one's answer ends there in fewer steps",
          "[quadratic-program]") {
  // The steepest even rise from 0 to 1 of n steps that are no larger than 1.5 / n, whose second
  // differences are bounded by t: least t. Then one row more, which the answer breaks by a little.
  constexpr Eigen::Index kCount = 80;
  const auto with_rows = [&](bool has_more) {
    QuadraticProgram program;
    program.cost = Eigen::VectorXd::Zero(kCount + 1);
    program.cost[kCount] = 1;
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> upper;
    const auto at = [&](Eigen::Index i, double factor) {
      if (i < 0) return;
      if (i >= kCount) upper.back() -= factor;
      if (i < kCount) entries.emplace_back(static_cast<int>(upper.size()) - 1, i, factor);
    };
    for (Eigen::Index i = -1; i <= kCount; ++i) {
      for (const double sign : {1.0, -1.0}) {
        upper.push_back(0);
        const double factor = sign * kCount * kCount / 4;
        at(i - 1, factor), at(i, -2 * factor), at(i + 1, factor);
        entries.emplace_back(static_cast<int>(upper.size()) - 1, kCount, -1);
      }
      upper.push_back(1.5);
      at(i + 1, kCount), at(i, -kCount);
    }
    if (has_more) {
      upper.push_back(0.999 * 0.75);
      at(kCount / 2 + 9, kCount / 2.0), at(kCount / 2 + 8, -kCount / 2.0);
    }
    const auto rows = static_cast<Eigen::Index>(upper.size());
    program.rows.resize(rows, kCount + 1);
    program.rows.setFromTriplets(entries.begin(), entries.end());
    program.row_lower = Eigen::VectorXd::Constant(rows, -kInfinite);
    program.row_upper = Eigen::Map<const Eigen::VectorXd>(upper.data(), rows);
    program.lower = Eigen::VectorXd::Constant(kCount + 1, -10);
    program.upper = Eigen::VectorXd::Constant(kCount + 1, 10);
    return program;
  };
  const Eigen::VectorXd start = Eigen::VectorXd::LinSpaced(kCount + 1, 0, 1);
  InteriorSolution first = solve_by_interior_point(with_rows(false), start);
  REQUIRE(first.end == InteriorEnd::Optimal);
  const QuadraticProgram more = with_rows(true);
  const InteriorSolution cold = solve_by_interior_point(more, start);
  first.row_multipliers.conservativeResizeLike(Eigen::VectorXd::Zero(more.rows.rows()));
  const InteriorSolution warm = solve_by_interior_point(more, first.y, {.near = &first});
  REQUIRE(cold.end == InteriorEnd::Optimal);
  REQUIRE(warm.end == InteriorEnd::Optimal);
  CHECK(warm.y[kCount] == Approx(cold.y[kCount]).epsilon(1e-9));
  CHECK(warm.iterations < cold.iterations);
}

TEST_CASE("rows that are not local have no augmented system", "[quadratic-program]") {
  constexpr Eigen::Index kCount = 200;
  QuadraticProgram program;
  program.cost = Eigen::VectorXd::Ones(kCount);
  program.rows = Eigen::MatrixXd(Eigen::MatrixXd::Ones(1, kCount)).sparseView();
  program.row_lower = Eigen::VectorXd::Constant(1, -1);
  program.row_upper = Eigen::VectorXd::Constant(1, 1);
  program.lower = Eigen::VectorXd::Constant(kCount, -1);
  program.upper = Eigen::VectorXd::Constant(kCount, 1);
  CHECK(augmented_system(ProgramSides(program)) == nullptr);
}

TEST_CASE("a string with a bounded curvature of many pieces is solved to the last digits",
          "[quadratic-program]") {
  // y'' >= -1 on n points from 0 to 0, as high as may be: the parabola x (1 - x) / 2, whose
  // integral is 1/12. The normal equations of such rows have a condition number of n^4, and fail.
  constexpr Eigen::Index kCount = 60000;
  const double h = 1.0 / (kCount + 1);
  QuadraticProgram program;
  program.cost = Eigen::VectorXd::Constant(kCount, -h);
  program.curvature.resize(kCount, kCount);
  for (Eigen::Index i = 0; i < kCount; ++i) program.curvature.insert(i, i) = 1e-9;
  program.rows.resize(kCount, kCount);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    if (i > 0) program.rows.insert(i, i - 1) = 1e-3 / (h * h);
    program.rows.insert(i, i) = -2e-3 / (h * h);
    if (i + 1 < kCount) program.rows.insert(i, i + 1) = 1e-3 / (h * h);
  }
  program.row_lower = Eigen::VectorXd::Constant(kCount, -1e-3);
  program.row_upper = Eigen::VectorXd::Constant(kCount, kInfinite);
  program.lower = Eigen::VectorXd::Constant(kCount, -1);
  program.upper = Eigen::VectorXd::Constant(kCount, 1);
  const InteriorSolution found = solve_by_interior_point(program, Eigen::VectorXd::Zero(kCount));
  CHECK(found.end == InteriorEnd::Optimal);
  CHECK(h * found.y.sum() == Approx(1.0 / 12).epsilon(1e-8));
}

}  // namespace camlaw::optim::quadratic_program_test
