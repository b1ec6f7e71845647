// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

/// Which parameters the residuals determine.
namespace camlaw::optim {

/// Directions along which the residuals change by less than this share of what they change along
/// the strongest, by columns of length one, count as undetermined. A Jacobian that is singular at
/// the minimum itself shows this much: such minima are found to the square root of rounding.
inline constexpr double kRankTolerance = 1e-8;

/// Columns divided by their lengths, so that units do not matter; a column of zeros stays.
struct ScaledColumns {
  explicit ScaledColumns(Eigen::MatrixXd columns);
  Eigen::MatrixXd matrix;
  Eigen::VectorXd lengths;  ///< 1 for a column of zeros
};

/// What the Jacobian says of its parameters, by singular values (docs/optimisation.md, (FT5)).
struct Identifiability {
  std::size_t rank = 0;
  double condition = 1;  ///< largest over least singular value that counts, columns scaled
  /// Pseudo-inverse of J^T J.
  Eigen::MatrixXd inverse;
  /// One for each direction without effect: what the parameters change together. Reduced, so that
  /// each has few entries that are not zero; the largest is 1 in scaled columns.
  std::vector<Eigen::VectorXd> directions;
};

Identifiability identify(const Eigen::MatrixXd& jacobian);

}  // namespace camlaw::optim
