// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <vector>

/// Bounded least squares, for multipliers.
namespace camlaw::optim {

enum class ColumnState {
  InPlay,    ///< fitted; its multiplier may still come out as zero
  Clamped,   ///< held at zero by its bound
  Dependent  ///< spanned by those in play: its multiplier, commonly zero, is one choice of many
};

/// min |A m + b|_2 over m, where m[j] >= 0 for each j whose `free` is false.
struct LeastSquaresResult {
  std::vector<double> multipliers;
  std::vector<ColumnState> columns;
  Eigen::VectorXd left;     ///< A m + b
  double residual_max = 0;  ///< its largest |entry|
  /// Largest over least singular value of all columns given, each scaled to a length near one:
  /// infinite where they depend on each other to working precision, so that m need not be unique.
  /// Of many columns an estimate from below by inverse iteration, commonly within a few percent.
  double condition = 1;
  int factorizations = 0;
};

/// Lengths of the columns may differ: they are scaled by powers of two. Exact up to rounding: the
/// search ends where no column pulls, or where following the pull gains nothing to rounding. Sparse
/// A takes time that grows with its entries if, but for a few dense rows, its columns can be
/// ordered so that it is banded. Where A or b is not finite, m is zero, the residual NaN and the
/// condition infinite.
LeastSquaresResult bounded_least_squares(const Eigen::SparseMatrix<double>& A,
                                         const Eigen::VectorXd& b, const std::vector<bool>& free);

namespace detail {

enum class Factorization { Dense, Sparse };

/// The same with a given factorization, else chosen by the expected work.
LeastSquaresResult bounded_least_squares(const Eigen::SparseMatrix<double>& A,
                                         const Eigen::VectorXd& b, const std::vector<bool>& free,
                                         Factorization factorization);

}  // namespace detail
}  // namespace camlaw::optim
