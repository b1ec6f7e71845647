// SPDX-License-Identifier: MIT
// Small linear programs: against the best of all corners.
#include "optim/solvers/small_program.h"

#include <catch2/catch.hpp>

#include "numerics/linear/dense.h"
#include "tests/random_numbers.h"

namespace camlaw::optim::small_program_test {
namespace {

using Eigen::Index;
using testing::Random;

/// The greatest gain over the corners: where as many limits hold as there are variables.
double best_corner(const Eigen::VectorXd& gain, const Eigen::MatrixXd& rows,
                   const Eigen::VectorXd& limits) {
  const Index n = rows.cols(), m = rows.rows();
  Eigen::MatrixXd all(m + n, n);
  all << rows, -Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd most(m + n);
  most << limits, Eigen::VectorXd::Zero(n);
  double best = 0;  // x = 0 is a corner
  for (Index i = 0; i < m + n; ++i) {
    for (Index j = i + 1; j < m + n; ++j) {
      for (Index k = j + 1; k < m + n; ++k) {
        Eigen::MatrixXd corner(3, 3);
        corner << all.row(i), all.row(j), all.row(k);
        const Eigen::VectorXd right = Eigen::Vector3d(most[i], most[j], most[k]);
        const Eigen::VectorXd x = solve_lu(corner, right);
        if (!x.allFinite() || !((all * x - most).maxCoeff() < 1e-9)) continue;
        best = std::max(best, gain.dot(x));
      }
    }
  }
  return best;
}

}  // namespace

TEST_CASE("a small linear program ends in the best corner", "[small-program]") {
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    const Index m = 5;
    Eigen::MatrixXd rows(m + 3, 3);
    Eigen::VectorXd limits(m + 3), gain(3);
    for (Index i = 0; i < m; ++i) {
      for (Index j = 0; j < 3; ++j) rows(i, j) = random.normal();
      limits[i] = i == 0 ? 0 : std::abs(random.normal());  // the first holds at x = 0
    }
    rows.bottomRows(3).setIdentity();
    limits.tail(3).setConstant(2);
    for (Index j = 0; j < 3; ++j) gain[j] = random.normal();
    const auto x = greatest_gain(gain, rows, limits);
    REQUIRE(x);
    CHECK((rows * *x - limits).maxCoeff() < 1e-10);
    CHECK(x->minCoeff() >= 0);
    CHECK(gain.dot(*x) == Approx(best_corner(gain, rows, limits)).epsilon(1e-9).margin(1e-9));
  }
}

TEST_CASE("entries that are rounding do not keep a small linear program from its corner",
          "[small-program]") {
  for (const double speck : {1e-18, 1e-17, -1e-16, 1e-15}) {
    Eigen::MatrixXd rows(3, 2);
    rows << 1, speck, 0, 1, speck, 1;
    const auto x = greatest_gain(Eigen::Vector2d(1, 1), rows, Eigen::Vector3d(0.25, 0.5, 0.5));
    REQUIRE(x);
    CHECK((*x)[0] == Approx(0.25));
    CHECK((*x)[1] == Approx(0.5));
  }
}

TEST_CASE("a gain without a bound has no greatest", "[small-program]") {
  Eigen::MatrixXd rows(1, 2);
  rows << 1, -1;
  CHECK_FALSE(greatest_gain(Eigen::Vector2d(1, 1), rows, Eigen::VectorXd::Ones(1)));
  const auto x = greatest_gain(Eigen::Vector2d(1, -1), rows, Eigen::VectorXd::Ones(1));
  REQUIRE(x);
  CHECK((*x)[0] == Approx(1));
}

}  // namespace camlaw::optim::small_program_test
