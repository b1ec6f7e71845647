// SPDX-License-Identifier: MIT
#include "numerics/linear/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

namespace camlaw::optim {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Pivoted = Eigen::ColPivHouseholderQR<MatrixXd>;
using Complete = Eigen::CompleteOrthogonalDecomposition<MatrixXd>;

Eigen::HouseholderSequence<MatrixXd, VectorXd> product(const Reflections& of) {
  return {of.packed, of.scales};
}

template <class Factors>
Factors factored(const MatrixXd& A, std::optional<double> tolerance) {
  Factors factors;
  if (tolerance) factors.setThreshold(*tolerance);
  factors.compute(A);
  return factors;
}

}  // namespace

MatrixXd Reflections::orthogonal() const { return product(*this); }

VectorXd Reflections::times(VectorXd x) const {
  x.applyOnTheLeft(product(*this));
  return x;
}

VectorXd Reflections::transposed_times(VectorXd y) const {
  y.applyOnTheLeft(product(*this).adjoint());
  return y;
}

VectorXd Reflections::solve(const VectorXd& b) const {
  const Index n = std::min(packed.rows(), packed.cols());
  const VectorXd y = transposed_times(b);
  VectorXd x = VectorXd::Zero(packed.cols());
  x.head(n) = packed.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(y.head(n));
  return x;
}

Reflections householder_qr(const MatrixXd& A) {
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  return {qr.matrixQR(), qr.hCoeffs()};
}

PivotedQr pivoted_qr(const MatrixXd& A, std::optional<double> tolerance) {
  const auto qr = factored<Pivoted>(A, tolerance);
  const auto& order = qr.colsPermutation().indices();
  return {{qr.matrixQR(), qr.hCoeffs()}, {order.begin(), order.end()}, qr.rank()};
}

VectorXd least_squares(const MatrixXd& A, const VectorXd& b) { return Pivoted(A).solve(b); }

MatrixXd least_squares(const MatrixXd& A, const MatrixXd& B) { return Pivoted(A).solve(B); }

ShortestSolution shortest_least_squares(const MatrixXd& A, const VectorXd& b,
                                        std::optional<double> tolerance) {
  const auto factors = factored<Complete>(A, tolerance);
  return {factors.solve(b), factors.rank()};
}

PseudoInverse pseudo_inverse(const MatrixXd& A) {
  const Complete factors(A);
  return {factors.pseudoInverse(), factors.rank()};
}

MatrixXd column_space(const MatrixXd& A) {
  const Pivoted qr(A);
  return qr.householderQ() * MatrixXd::Identity(A.rows(), qr.rank());
}

MatrixXd left_null_space(const MatrixXd& A, double tolerance) {
  if (A.cols() == 0) return MatrixXd::Identity(A.rows(), A.rows());
  const auto qr = factored<Eigen::FullPivHouseholderQR<MatrixXd>>(A, tolerance);
  const MatrixXd Q = qr.matrixQ();
  return Q.rightCols(A.rows() - qr.rank());
}

SymmetricEigen symmetric_eigen(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(A);
  return {solved.eigenvalues(), solved.eigenvectors()};
}

RightSingular right_singular(const MatrixXd& A) {
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  const Index rows = std::min(A.rows(), A.cols());
  const MatrixXd triangle = qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<MatrixXd> svd(triangle, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

VectorXd solve_lu(const MatrixXd& A, const VectorXd& b) {
  return Eigen::FullPivLU<MatrixXd>(A).solve(b);
}

MatrixXd solve_lu(const MatrixXd& A, const MatrixXd& B) {
  return Eigen::FullPivLU<MatrixXd>(A).solve(B);
}

VectorXd solve_ldlt(const MatrixXd& A, const VectorXd& b) {
  return Eigen::LDLT<MatrixXd>(A).solve(b);
}

std::optional<MatrixXd> positive_definite_inverse(const MatrixXd& A, double least) {
  const Eigen::LDLT<MatrixXd> factors(A);
  if (!(factors.vectorD().minCoeff() > least)) return {};
  return factors.solve(MatrixXd::Identity(A.rows(), A.cols()));
}

}  // namespace camlaw::optim
