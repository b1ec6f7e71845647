// SPDX-License-Identifier: MIT
#include "numerics/linear/small_program.h"

#include <cmath>
#include <vector>

namespace camlaw::optim {
namespace {

using Eigen::Index;

constexpr double kZero = 1e-11;  // of entries of order one

/// The rows with a slack each, the gain below them, the limits in the last column.
class Tableau {
 public:
  Tableau(const Eigen::VectorXd& gain, const Eigen::MatrixXd& rows, const Eigen::VectorXd& limits)
      : entries_(Eigen::MatrixXd::Zero(rows.rows() + 1, rows.cols() + 1)) {
    entries_.topLeftCorner(rows.rows(), rows.cols()) = rows;
    entries_.topRightCorner(rows.rows(), 1) = limits;
    entries_.bottomLeftCorner(1, gain.size()) = -gain.transpose();
    for (Index j = 0; j < rows.cols(); ++j) outside_.push_back(j);
    for (Index i = 0; i < rows.rows(); ++i) inside_.push_back(rows.cols() + i);
  }

  /// The column to enter: the steepest one, or the first of all variables that gains.
  std::optional<Index> entering(bool first) const {
    std::optional<Index> best;
    for (Index j = 0; j + 1 < entries_.cols(); ++j) {
      const double here = cost(j);
      if (here >= -kZero) continue;
      const bool better = !best || (first ? outside(j) < outside(*best) : here < cost(*best));
      if (better) best = j;
    }
    return best;
  }

  /// The row that limits the column most; of equal ones that of the first variable.
  std::optional<Index> leaving(Index column) const {
    std::optional<Index> best;
    double least = 0;
    for (Index i = 0; i + 1 < entries_.rows(); ++i) {
      if (entries_(i, column) <= kZero) continue;
      const double ratio = entries_(i, entries_.cols() - 1) / entries_(i, column);
      const bool better = !best || ratio < least || (ratio == least && inside(i) < inside(*best));
      if (better) best = i, least = ratio;
    }
    return best;
  }

  /// The entering variable takes the place of the leaving one.
  void exchange(Index row, Index column) {
    const double pivot = entries_(row, column);
    const Eigen::VectorXd by = entries_.col(column);
    entries_.row(row) /= pivot;
    entries_.col(column).setZero();
    entries_(row, column) = 1 / pivot;
    for (Index i = 0; i < entries_.rows(); ++i) {
      if (i != row && by[i] != 0) entries_.row(i) -= by[i] * entries_.row(row);
    }
    std::swap(outside_[static_cast<std::size_t>(column)], inside_[static_cast<std::size_t>(row)]);
  }

  Eigen::VectorXd values() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(entries_.cols() - 1);
    for (Index i = 0; i + 1 < entries_.rows(); ++i) {
      if (inside(i) < x.size()) x[inside(i)] = std::max(0.0, entries_(i, entries_.cols() - 1));
    }
    return x;
  }

 private:
  double cost(Index column) const { return entries_(entries_.rows() - 1, column); }
  Index outside(Index column) const { return outside_[static_cast<std::size_t>(column)]; }
  Index inside(Index row) const { return inside_[static_cast<std::size_t>(row)]; }

  Eigen::MatrixXd entries_;
  std::vector<Index> outside_, inside_;  ///< variables that are zero, and the others by their rows
};

}  // namespace

std::optional<Eigen::VectorXd> greatest_gain(const Eigen::VectorXd& gain,
                                             const Eigen::MatrixXd& rows,
                                             const Eigen::VectorXd& limits) {
  Tableau tableau(gain, rows, limits);
  const Index many = rows.rows() + rows.cols();
  for (Index step = 0; step < 20 * many; ++step) {
    const auto column = tableau.entering(step > many);
    if (!column) break;
    const auto row = tableau.leaving(*column);
    if (!row) return {};
    tableau.exchange(*row, *column);
  }
  return tableau.values();
}

}  // namespace camlaw::optim
