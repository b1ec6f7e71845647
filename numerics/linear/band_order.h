// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace camlaw::optim {

/// A's columns in an order that keeps those that share a row close together (Cuthill and McKee
/// 1969). A periodic profile is folded: its band is twice as wide as that of an open one.
std::vector<int> band_order(const Eigen::SparseMatrix<double>& A);

}  // namespace camlaw::optim
