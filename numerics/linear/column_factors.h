// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <memory>
#include <vector>

/// Least squares over chosen columns of a matrix, without bounds.
namespace camlaw::optim {

/// A column that the others span but for this share of its length is dependent. Rounding was seen
/// to leave 1e-16, of 20000 columns too; the least pivot of third differences of n points is
/// n^-2.5, that is 1e-10 for n = 10000.
constexpr double kDependent = 1e-13;

/// Chosen columns C, factored by orthogonal transformations (normal equations would square the
/// condition, which second differences of n points bring to n^2).
class ColumnFactors {
 public:
  virtual ~ColumnFactors() = default;

  /// x with the least |C x - target|_2; zero for the dependent columns.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& target) const = 0;

  /// Which columns the others span, to working precision.
  virtual const std::vector<bool>& dependent() const = 0;

  /// Largest over least singular value; infinite where a column is dependent.
  virtual double condition() const = 0;
};

using FactorColumns =
    std::function<std::unique_ptr<ColumnFactors>(const std::vector<int>& columns)>;

using Factorize = FactorColumns (*)(const Eigen::SparseMatrix<double>& A);

/// By Householder QR with column pivoting. A's columns have lengths near one; A outlives the
/// result.
FactorColumns dense_factors(const Eigen::SparseMatrix<double>& A);

/// By rotations in a band, with dense rows apart. Likewise.
FactorColumns sparse_factors(const Eigen::SparseMatrix<double>& A);

/// The one that is expected to take less time; dense where that is short.
FactorColumns cheaper_factors(const Eigen::SparseMatrix<double>& A);

}  // namespace camlaw::optim
