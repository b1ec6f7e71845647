// SPDX-License-Identifier: MIT
#include "numerics/linear/dense.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "numerics/polynomial/gauss_legendre.h"
#include "tests/random_numbers.h"

namespace camlaw::optim::dense_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::Random;

constexpr double kRounding = 1e-12;

MatrixXd random_matrix(Random& random, Index rows, Index columns) {
  MatrixXd A(rows, columns);
  for (Index i = 0; i < A.size(); ++i) A.data()[i] = random(-1, 1);
  return A;
}

VectorXd random_vector(Random& random, Index size) { return random_matrix(random, size, 1); }

/// Not by operators in each place: every combination of them is compiled anew.
MatrixXd product(const MatrixXd& A, const MatrixXd& B) { return A * B; }
MatrixXd transposed(const MatrixXd& A) { return A.transpose(); }
double distance(const MatrixXd& A, const MatrixXd& B) { return (A - B).cwiseAbs().maxCoeff(); }
MatrixXd unit(Index size) { return MatrixXd::Identity(size, size); }

/// Seven rows and five columns of rank three.
MatrixXd of_rank_three(Random& random) {
  return product(random_matrix(random, 7, 3), random_matrix(random, 3, 5));
}

/// How far what is left of A x = b is from orthogonal to all columns.
double slope(const MatrixXd& A, const MatrixXd& x, const MatrixXd& b) {
  return product(transposed(A), product(A, x) - b).cwiseAbs().maxCoeff();
}

TEST_CASE("the reflections of QR are Q and R", "[dense]") {
  Random random(1);
  for (const auto& [rows, columns] : {std::pair<Index, Index>{7, 4}, {4, 4}, {3, 5}}) {
    const MatrixXd A = random_matrix(random, rows, columns);
    const Reflections qr = householder_qr(A);
    const MatrixXd Q = qr.orthogonal(), R = qr.packed.triangularView<Eigen::Upper>();
    const VectorXd x = random_vector(random, rows);
    CAPTURE(rows, columns);
    CHECK(distance(product(transposed(Q), Q), unit(rows)) < kRounding);
    CHECK(distance(product(Q, R), A) < kRounding);
    CHECK(distance(qr.times(x), product(Q, x)) < kRounding);
    CHECK(distance(qr.transposed_times(x), product(transposed(Q), x)) < kRounding);
    CHECK(slope(A, qr.solve(x), x) < kRounding);
  }
}

TEST_CASE("pivoted QR tells the rank and which columns come first", "[dense]") {
  Random random(2);
  const MatrixXd A = of_rank_three(random);
  const PivotedQr qr = pivoted_qr(A, 1e-10);
  REQUIRE(qr.rank == 3);
  const MatrixXd R = qr.factors.packed.triangularView<Eigen::Upper>();
  const MatrixXd QR = product(qr.factors.orthogonal(), R);
  for (Index j = 0; j < A.cols(); ++j) {
    CHECK(distance(QR.col(j), A.col(qr.columns[static_cast<std::size_t>(j)])) < kRounding);
  }
  CHECK(pivoted_qr(A, 2.0).rank == 0);
}

TEST_CASE("least squares leave nothing along the columns", "[dense]") {
  Random random(3);
  const MatrixXd A = of_rank_three(random), B = random_matrix(random, 7, 2);
  const VectorXd b = B.col(0);
  CHECK(slope(A, least_squares(A, b), b) < kRounding);
  CHECK(slope(A, least_squares(A, B), B) < kRounding);
  const auto [x, rank] = shortest_least_squares(A, b);
  CHECK(rank == 3);
  CHECK(slope(A, x, b) < kRounding);
  const PseudoInverse inverse = pseudo_inverse(A);
  CHECK(inverse.rank == 3);
  CHECK(distance(product(inverse.matrix, b), x) < kRounding);  // so x is the shortest
  CHECK(distance(product(product(A, inverse.matrix), A), A) < kRounding);
}

TEST_CASE("a column space and what is orthogonal to it make up the whole", "[dense]") {
  Random random(4);
  const MatrixXd A = of_rank_three(random);
  const MatrixXd span = column_space(A), beside = left_null_space(A, 1e-10);
  REQUIRE(span.cols() == 3);
  REQUIRE(beside.cols() == 4);
  CHECK(distance(product(transposed(span), span), unit(3)) < kRounding);
  CHECK(distance(product(transposed(beside), beside), unit(4)) < kRounding);
  CHECK(product(transposed(beside), A).cwiseAbs().maxCoeff() < kRounding);
  CHECK(distance(product(span, product(transposed(span), A)), A) < kRounding);
  CHECK(distance(left_null_space(MatrixXd(3, 0), 1e-10), unit(3)) == 0);
}

TEST_CASE("eigenvalues and singular values put their matrices together again", "[dense]") {
  Random random(5);
  const MatrixXd A = random_matrix(random, 6, 4), gram = product(transposed(A), A);
  const SymmetricEigen eigen = symmetric_eigen(gram);
  const MatrixXd diagonal = eigen.values.asDiagonal();
  CHECK(distance(product(product(eigen.vectors, diagonal), transposed(eigen.vectors)), gram) <
        kRounding);
  const RightSingular singular = right_singular(A);
  REQUIRE(singular.values.size() == 4);
  for (Index k = 0; k < 4; ++k) {
    CHECK(std::pow(singular.values[k], 2) == Approx(eigen.values[3 - k]));
    const VectorXd image = product(A, singular.vectors.col(k));
    CHECK(image.norm() == Approx(singular.values[k]));
  }
  CHECK(right_singular(transposed(A)).vectors.cols() == 6);
}

TEST_CASE("linear equations are solved, and their residual tells where they cannot be", "[dense]") {
  Random random(6);
  const MatrixXd A = random_matrix(random, 5, 5), gram = product(transposed(A), A);
  const VectorXd b = random_vector(random, 5);
  CHECK(distance(product(A, solve_lu(A, b)), b) < 1e-10);
  CHECK(distance(product(A, solve_lu(A, unit(5))), unit(5)) < 1e-10);
  CHECK(distance(product(gram, solve_ldlt(gram, b)), b) < 1e-8);
  const auto inverse = positive_definite_inverse(gram, 1e-12);
  REQUIRE(inverse);
  CHECK(distance(product(gram, *inverse), unit(5)) < 1e-8);
  MatrixXd singular = unit(2);
  singular(1, 1) = 0;
  CHECK_FALSE(positive_definite_inverse(singular, 1e-12));
  const VectorXd ones = VectorXd::Ones(2);
  CHECK(distance(product(singular, solve_lu(singular, ones)), ones) == Approx(1));
}

TEST_CASE("Gauss-Legendre rules are exact to their degrees", "[dense]") {
  for (const int points : {10, 13, 30}) {
    const GaussLegendre& rule = gauss_legendre(points);
    for (int power = 0; power < 2 * points; power += 2) {
      double sum = 0;
      for (std::size_t k = 0; k < rule.places.size(); ++k) {
        const int sides = rule.places[k] == 0 ? 1 : 2;
        sum += sides * rule.weights[k] * std::pow(rule.places[k], power);
      }
      CAPTURE(points, power);
      CHECK(sum == Approx(2.0 / (power + 1)));
    }
  }
  CHECK_THROWS_AS(gauss_legendre(11), std::invalid_argument);
}

}  // namespace
}  // namespace camlaw::optim::dense_test
