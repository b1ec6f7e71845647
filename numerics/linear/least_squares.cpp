// SPDX-License-Identifier: MIT
#include "numerics/linear/least_squares.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "numerics/linear/bounded_search.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// The power of two next to a vector's length; exact to multiply with.
double power_of_two(const Eigen::Ref<const VectorXd>& values) {
  const double length = values.stableNorm();
  return length > 0 ? std::ldexp(1.0, static_cast<int>(std::lround(std::log2(length)))) : 1;
}

Eigen::Map<const VectorXd> entries(const Matrix& A, Index column) {
  const int begin = A.outerIndexPtr()[column];
  return {A.valuePtr() + begin, A.outerIndexPtr()[column + 1] - begin};
}

bool finite(const Matrix& A, const VectorXd& b) {
  return Eigen::Map<const VectorXd>(A.valuePtr(), A.nonZeros()).allFinite() && b.allFinite();
}

/// Without a search: no columns, no rows, or not finite.
LeastSquaresResult zero(const Matrix& A, const VectorXd& b, bool is_finite) {
  LeastSquaresResult result;
  result.multipliers.assign(static_cast<std::size_t>(A.cols()), 0.0);
  result.columns.assign(result.multipliers.size(), ColumnState::Dependent);
  if (A.cols() > 0) result.condition = std::numeric_limits<double>::infinity();
  result.left = b;
  if (!is_finite) result.left.setConstant(std::numeric_limits<double>::quiet_NaN());
  if (b.size() > 0) result.residual_max = result.left.cwiseAbs().maxCoeff();
  if (!is_finite) result.residual_max = std::numeric_limits<double>::quiet_NaN();
  return result;
}

LeastSquaresResult solve(Matrix A, VectorXd b, const std::vector<bool>& free, Factorize factorize) {
  assert(A.rows() == b.size());
  assert(static_cast<std::size_t>(A.cols()) == free.size());
  A.makeCompressed();
  const bool is_finite = finite(A, b);
  if (!is_finite || A.rows() == 0 || A.cols() == 0) return zero(A, b, is_finite);
  const double unit = power_of_two(b);
  VectorXd lengths(A.cols());
  for (Index j = 0; j < A.cols(); ++j) lengths[j] = power_of_two(entries(A, j));
  A = A * lengths.cwiseInverse().asDiagonal();
  b /= unit;
  LeastSquaresResult result = bounded_search(BoundedProblem(A, b, free), factorize);
  const Eigen::Map<VectorXd> m(result.multipliers.data(), A.cols());
  result.left = (A * m + b) * unit;
  result.residual_max = result.left.cwiseAbs().maxCoeff();
  for (Index j = 0; j < A.cols(); ++j) {
    result.multipliers[static_cast<std::size_t>(j)] *= unit / lengths[j];
  }
  return result;
}

}  // namespace

LeastSquaresResult bounded_least_squares(const Matrix& A, const VectorXd& b,
                                         const std::vector<bool>& free) {
  return solve(A, b, free, cheaper_factors);
}

LeastSquaresResult detail::bounded_least_squares(const Matrix& A, const VectorXd& b,
                                                 const std::vector<bool>& free,
                                                 Factorization factorization) {
  const bool dense = factorization == Factorization::Dense;
  return solve(A, b, free, dense ? dense_factors : sparse_factors);
}

}  // namespace camlaw::optim
