// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "numerics/linear/banded_qr.h"
#include "numerics/linear/dense.h"

namespace camlaw::optim {

/// Least squares over C = [S; D], up to an order of the rows: S banded, D a few dense rows, as of a
/// variable that all limits share (a peak's bound, a base radius). Rotated into R like the others,
/// D's rows would fill it; so they update what S = Q R gives:
///
///   x = (x_B, x_N)             independent and dependent columns of S; x_N may be chosen freely
///   R_B x_B + R_N x_N = c + u  c: the rotated target of S; u: the change on D's account
///   W^T (c + u) + E x_N ~ d    W = R_B^-T D_B^T,  E = D_N - W^T R_N,  d: the target of D
///
/// and |u|^2 + |W^T (c + u) + E x_N - d|^2 is to be least. With E = Q_E [T; 0], E's independent
/// columns meet the first rows of Q_E^T(..) exactly and u is the least-squares answer to the rest.
class BorderedQr {
 public:
  BorderedQr(const Eigen::SparseMatrix<double, Eigen::RowMajor>& S, const Eigen::MatrixXd& D,
             double tolerance);

  const std::vector<bool>& dependent() const { return dependent_; }

  /// x with the least |[S; D] x - target|; zero for the dependent columns.
  Eigen::VectorXd solve(const Eigen::VectorXd& target_S, const Eigen::VectorXd& target_D) const;

  /// Estimates of singular values, from inside the interval that they span.
  double largest_singular_value() const;
  double least_singular_value() const;  ///< if no column is dependent

 private:
  /// A vector of the columns' span: in the rows of R and in those of D.
  struct Image {
    Eigen::VectorXd R, D;
  };

  void factor_border(const std::vector<Eigen::Index>& spare, double tolerance);
  void factor_update();
  Eigen::VectorXd solve(const Image& target) const;
  Image solve_transposed(const Eigen::VectorXd& x) const;

  BandedQr qr_;
  Eigen::MatrixXd D_, W_;
  std::vector<bool> dependent_;
  std::vector<Eigen::Index> chosen_;  ///< E's independent columns, as columns of C
  Eigen::MatrixXd Q_, T_;             ///< of E
  Eigen::MatrixXd G_;                 ///< W times Q_E's other columns
  Reflections update_;                ///< of [G; I]
};

}  // namespace camlaw::optim
