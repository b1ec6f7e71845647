// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace camlaw::optim {

/// A matrix taken apart into a few dense rows and the rest, which an order of the columns makes
/// banded.
struct BandedSplit {
  std::vector<Eigen::Index> dense_rows;
  Eigen::MatrixXd dense;
  Eigen::SparseMatrix<double> banded;  ///< with the dense rows empty
  std::vector<int> places;             ///< of the columns in the band
};

BandedSplit banded_split(const Eigen::SparseMatrix<double>& A);

/// Rotations to bring the banded part into triangular form, times their length.
double rotated_entries(const BandedSplit& split);

}  // namespace camlaw::optim
