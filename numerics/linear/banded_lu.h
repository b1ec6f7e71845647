// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace camlaw::optim {

/// P A = L U of a square banded matrix with partial pivoting, in time and memory linear in its rows
/// (Golub and Van Loan, Matrix Computations, 4.3.5). A may be indefinite with zeros on its
/// diagonal, as the conditions of optimality are.
class BandedLu {
 public:
  /// Entries (i, j) are where |i - j| <= `half`.
  BandedLu(Eigen::Index size, Eigen::Index half);

  /// Where entry (i, j) is among the entries of A.
  Eigen::Index place(Eigen::Index row, Eigen::Index column) const {
    return row * width_ + column - row + half_;
  }
  /// As many numbers as there are places.
  Eigen::Index places() const { return size_ * width_; }

  /// Replaces A. False where a pivot vanishes or is not a number.
  bool factor(const std::vector<double>& entries);
  bool factor(std::vector<double>&& entries);

  /// A^-1 b.
  Eigen::VectorXd solve(Eigen::VectorXd b) const;

 private:
  bool eliminate();
  /// Row i from column i on.
  double* row(Eigen::Index i) { return entries_.data() + place(i, i); }
  const double* row(Eigen::Index i) const { return entries_.data() + place(i, i); }

  Eigen::Index size_, half_, width_;  ///< the width with room for what pivoting adds
  std::vector<double> entries_, multipliers_;
  std::vector<Eigen::Index> pivots_;
};

}  // namespace camlaw::optim
