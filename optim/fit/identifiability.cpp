// SPDX-License-Identifier: MIT
#include "optim/fit/identifiability.h"

#include <algorithm>

#include "numerics/linear/dense.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Another basis of the columns' span, by elimination with the largest entry as pivot. Directions
/// that have nothing to do with each other, which singular vectors mix, come apart.
void reduce(MatrixXd& basis) {
  // Entries that rounding alone leaves; far below what anyone would call taking part.
  constexpr double kNothing = 1e-6;
  std::vector<bool> taken(static_cast<std::size_t>(basis.rows()), false);
  for (Index k = 0; k < basis.cols(); ++k) {
    Index pivot = 0;
    double largest = -1;
    for (Index i = 0; i < basis.rows(); ++i) {
      if (taken[static_cast<std::size_t>(i)]) continue;
      const double size = basis.row(i).tail(basis.cols() - k).cwiseAbs().maxCoeff();
      if (size > largest) largest = size, pivot = i;
    }
    taken[static_cast<std::size_t>(pivot)] = true;
    Index column = 0;
    basis.row(pivot).tail(basis.cols() - k).cwiseAbs().maxCoeff(&column);
    basis.col(k).swap(basis.col(k + column));
    basis.col(k) /= basis(pivot, k);
    for (Index other = 0; other < basis.cols(); ++other) {
      if (other != k) basis.col(other) -= basis(pivot, other) * basis.col(k);
    }
  }
  for (Index k = 0; k < basis.cols(); ++k) {
    basis.col(k) /= basis.col(k).cwiseAbs().maxCoeff();
  }
  basis = (basis.array().abs() < kNothing).select(0.0, basis);
}

}  // namespace

ScaledColumns::ScaledColumns(MatrixXd columns)
    : matrix(std::move(columns)), lengths(matrix.cols()) {
  for (Index j = 0; j < matrix.cols(); ++j) {
    const double length = matrix.col(j).stableNorm();
    lengths[j] = length > 0 ? length : 1;
    matrix.col(j) /= lengths[j];
  }
}

Identifiability identify(const MatrixXd& jacobian) {
  Identifiability result;
  const Index m = jacobian.cols();
  result.inverse = MatrixXd::Zero(m, m);
  if (m == 0) return result;
  const ScaledColumns columns(jacobian);
  const auto [values, V] = right_singular(columns.matrix);
  Index rank = 0;
  while (rank < values.size() && values[rank] > kRankTolerance * values[0]) ++rank;
  result.rank = static_cast<std::size_t>(rank);
  if (rank > 0) result.condition = values[0] / values[rank - 1];
  // Rows of V by singular values and lengths of columns; its products make the inverse.
  const MatrixXd half = columns.lengths.cwiseInverse().asDiagonal() * V.leftCols(rank) *
                        values.head(rank).cwiseInverse().asDiagonal();
  result.inverse = half * half.transpose();
  MatrixXd null = V.rightCols(m - rank);
  reduce(null);
  for (Index k = 0; k < null.cols(); ++k) {
    result.directions.push_back(null.col(k).cwiseQuotient(columns.lengths));
  }
  return result;
}

}  // namespace camlaw::optim
