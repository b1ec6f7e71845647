// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "numerics/linear/quadratic_program.h"

namespace camlaw::optim {

/// minimise cost . y + y . curvature y / 2 where G y <= h and E y = e: each row of a program with a
/// side for each of its bounds, then the bounds of the variables. Rows are kept once, and after
/// them one for each variable; sides refer to them.
class ProgramSides {
 public:
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  explicit ProgramSides(const QuadraticProgram& program);

  Eigen::Index variables() const { return cost.size(); }
  /// Of sides.
  Eigen::Index count() const { return level.size(); }
  Eigen::Index row(Eigen::Index side) const { return rows_[static_cast<std::size_t>(side)]; }
  double sign(Eigen::Index side) const { return signs_[static_cast<std::size_t>(side)]; }

  /// The number of a side's bound among those of the program's rows, then of its variables, each
  /// lower one before its upper one; how many numbers there are.
  Eigen::Index bound(Eigen::Index side) const;
  Eigen::Index bounds() const { return 2 * (rows.rows() + equations.rows() + idle_ + variables()); }

  /// G y.
  Eigen::VectorXd times(const Eigen::VectorXd& y) const;
  /// What sides say, added up by row: G = S rows, with S's signs; this is S^T z.
  Eigen::VectorXd by_row(const Eigen::VectorXd& z) const;
  /// The same of weights, which have no sign: the diagonal of S^T W S.
  Eigen::VectorXd weights_by_row(const Eigen::VectorXd& weights) const;
  /// G^T z.
  Eigen::VectorXd transposed(const Eigen::VectorXd& z) const;
  /// Sums of the magnitudes that make up each side of G y; each equation; each column of G^T z and
  /// E^T w.
  Eigen::VectorXd side_terms(const Eigen::VectorXd& y) const;
  Eigen::VectorXd equation_terms(const Eigen::VectorXd& y) const;
  Eigen::VectorXd column_terms(const Eigen::VectorXd& z, const Eigen::VectorXd& w) const;

  /// The gradient of the cost.
  Eigen::VectorXd slope(const Eigen::VectorXd& y) const;
  double objective(const Eigen::VectorXd& y) const;
  bool is_linear() const { return curvature.nonZeros() == 0; }

  Eigen::VectorXd cost, level;
  Eigen::SparseMatrix<double> curvature;    ///< compressed; of size 0 where there is none
  Rows rows;                                ///< without those that are equations or have no bound
  std::vector<Eigen::Index> program_rows;   ///< what they are in the program
  Rows equations;                           ///< equations y = values
  std::vector<Eigen::Index> equation_rows;  ///< what they are in the program
  Eigen::VectorXd values;

 private:
  std::vector<Eigen::Index> rows_;  ///< of the sides
  std::vector<double> signs_;
  Eigen::Index idle_ = 0;  ///< rows of the program without a bound
};

}  // namespace camlaw::optim
