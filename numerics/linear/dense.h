// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

/// Factorizations of dense matrices. They are Eigen's, compiled here alone: a unit that includes
/// Eigen's own headers for them compiles the templates anew, which takes seconds each time.
///
/// None of these functions throws but for memory. Entries that are not finite give results that are
/// not; a `tolerance` is a share of the largest pivot, without one it is that of rounding.
namespace camlaw::optim {

/// A = Q R by Householder reflections, as they are stored: R in the upper triangle of `packed`, the
/// reflections below.
struct Reflections {
  Eigen::MatrixXd packed;
  Eigen::VectorXd scales;  ///< of the reflections

  Eigen::MatrixXd orthogonal() const;                         ///< Q, square
  Eigen::VectorXd times(Eigen::VectorXd x) const;             ///< Q x
  Eigen::VectorXd transposed_times(Eigen::VectorXd y) const;  ///< Q^T y
  /// x with the least |A x - b|_2, where the rank is full; zero for columns beyond A's rows. Not
  /// finite, or far off, where the rank is not full.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
};

/// By Householder QR without pivoting.
Reflections householder_qr(const Eigen::MatrixXd& A);

/// A P = Q R with the columns in order of what the ones before leave of them.
struct PivotedQr {
  Reflections factors;
  std::vector<Eigen::Index> columns;  ///< A's, by their places in R
  Eigen::Index rank = 0;              ///< pivots above the tolerance
};

/// By Householder QR with column pivoting (Businger and Golub 1965).
PivotedQr pivoted_qr(const Eigen::MatrixXd& A, std::optional<double> tolerance = {});

/// x with the least |A x - b|_2, by QR with column pivoting; zero for columns that depend on others
/// to working precision.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
/// Likewise, column by column of B.
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// The shortest x with the least |A x - b|_2.
struct ShortestSolution {
  Eigen::VectorXd x;
  Eigen::Index rank = 0;  ///< of A
};

/// By a complete orthogonal decomposition: QR with column pivoting, and R's dependent columns
/// reflected away.
ShortestSolution shortest_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                        std::optional<double> tolerance = {});

/// The Moore-Penrose inverse, by a complete orthogonal decomposition.
struct PseudoInverse {
  Eigen::MatrixXd matrix;
  Eigen::Index rank = 0;
};
PseudoInverse pseudo_inverse(const Eigen::MatrixXd& A);

/// An orthonormal basis of the span of A's columns, by QR with column pivoting.
Eigen::MatrixXd column_space(const Eigen::MatrixXd& A);

/// An orthonormal basis of what is orthogonal to all columns of A, by Householder QR with complete
/// pivoting.
Eigen::MatrixXd left_null_space(const Eigen::MatrixXd& A, double tolerance);

/// A = V diag(values) V^T of a symmetric matrix, the least eigenvalue first.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< orthonormal columns
};

/// By tridiagonal QR iterations; reads the lower triangle alone.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

/// Singular values, the largest first, and right singular vectors: A^T A = V diag(values)^2 V^T.
struct RightSingular {
  Eigen::VectorXd values;   ///< as many as A has rows or columns, whichever are fewer
  Eigen::MatrixXd vectors;  ///< V, square
};

/// By Jacobi's rotations of QR's triangle, which has A's singular values and few rows.
RightSingular right_singular(const Eigen::MatrixXd& A);

/// x with A x = b of a square matrix, by LU with complete pivoting. Where A is singular, one of the
/// solutions if there is any: the residual tells.
Eigen::VectorXd solve_lu(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
/// Likewise, column by column of B.
Eigen::MatrixXd solve_lu(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// x with A x = b of a symmetric semidefinite matrix, by LDL^T with diagonal pivoting; reads the
/// lower triangle alone. Pivots that are zero leave zeros in x.
Eigen::VectorXd solve_ldlt(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The inverse of a symmetric matrix, by LDL^T; none where a pivot is not above `least`.
std::optional<Eigen::MatrixXd> positive_definite_inverse(const Eigen::MatrixXd& A, double least);

}  // namespace camlaw::optim
