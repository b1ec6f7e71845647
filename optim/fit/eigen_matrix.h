// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "optim/fit/least_squares.h"

/// A SquareMatrix as Eigen's, without a copy. Not in least_squares.h: who reads a fit's deviations
/// need not have Eigen.
namespace camlaw::optim {

inline Eigen::Map<Eigen::MatrixXd> as_eigen(SquareMatrix& matrix) {
  const auto size = static_cast<Eigen::Index>(matrix.size());
  return {matrix.data(), size, size};
}
inline Eigen::Map<const Eigen::MatrixXd> as_eigen(const SquareMatrix& matrix) {
  const auto size = static_cast<Eigen::Index>(matrix.size());
  return {matrix.data(), size, size};
}

}  // namespace camlaw::optim
