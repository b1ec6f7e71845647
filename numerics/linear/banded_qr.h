// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace camlaw::optim {

/// A = Q R of a banded matrix by plane rotations, in time linear in its rows: rows are rotated into
/// R one by one in the order of their first columns (George and Heath 1980), so that a row comes to
/// rest within the band. A column whose pivot vanishes depends on the columns before it: R's row is
/// taken out again and rotated into the rows below (Heath 1982).
///
/// R has a row for each column; that of a dependent column is empty. Vectors "by column" have an
/// entry for each column of A.
class BandedQr {
 public:
  /// Pivots up to `tolerance` count as zero.
  BandedQr(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, double tolerance);

  const std::vector<bool>& dependent() const { return dependent_; }

  /// Q^T target by column: what R x is compared with. Zero for dependent columns.
  Eigen::VectorXd rotated(const Eigen::VectorXd& target) const;

  /// R x = y over the independent columns; zero for the others.
  Eigen::VectorXd solve(const Eigen::VectorXd& y) const;

  /// R^T y = x over the independent columns; zero for the others.
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& x) const;

  /// R x and R^T y, of all columns.
  Eigen::VectorXd times(const Eigen::VectorXd& x) const;
  Eigen::VectorXd transposed_times(const Eigen::VectorXd& y) const;

 private:
  struct Rotation {
    std::size_t column;  ///< of R's row that takes part
    double cosine, sine;
  };
  /// What the rotations up to `end` carry down: A's row, or R's row that was taken out.
  struct Journey {
    std::size_t row;
    bool from_r;
    std::size_t end;
  };

  double* row(std::size_t j) { return values_.data() + offsets_[j]; }
  const double* row(std::size_t j) const { return values_.data() + offsets_[j]; }
  void reserve(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A,
               const std::vector<int>& order);
  void carry(std::size_t row, bool from_r, std::size_t first);
  void rotate(std::size_t column);
  void take_out(std::size_t column);

  std::vector<std::size_t> offsets_, ends_;  ///< row j of R: columns j .. ends_[j] - 1
  std::vector<double> values_;
  std::vector<bool> dependent_;
  std::vector<Rotation> rotations_;
  std::vector<Journey> journeys_;
  std::vector<double> carried_;  ///< the row on its way, by column; zero between journeys
  std::size_t carried_end_ = 0;
};

}  // namespace camlaw::optim
