// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace camlaw::optim {

/// m, with what follows from it.
struct BoundedPoint {
  Eigen::VectorXd m, residual;
  Eigen::VectorXd terms;  ///< sum of the absolute terms of each entry of the residual
  double square = 0;      ///< |residual|^2
  double rounding = 0;    ///< how far rounding may move it
};

/// min |A m + b|_2, where m[j] >= 0 unless free[j], with its measures of rounding. Holds
/// references.
class BoundedProblem {
 public:
  BoundedProblem(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b,
                 const std::vector<bool>& free)
      : A_(A), sizes_(A.cwiseAbs()), b_(b), free_(free) {}

  const Eigen::SparseMatrix<double>& A() const { return A_; }
  const Eigen::VectorXd& b() const { return b_; }
  const std::vector<bool>& free() const { return free_; }
  bool bounded(Eigen::Index j) const { return !free_[static_cast<std::size_t>(j)]; }

  BoundedPoint at(Eigen::VectorXd m) const;

  /// m with what is beyond a bound set on it.
  Eigen::VectorXd clamped(Eigen::VectorXd m) const;

  /// How fast half the square falls along each column; zero where that may be rounding.
  Eigen::VectorXd pulls(const BoundedPoint& point) const;

  /// Optimal to what rounding leaves of a fit.
  bool conditions_hold(const BoundedPoint& point) const;

  /// Whether the residuals differ by no more than rounding.
  bool same_residual(const BoundedPoint& a, const BoundedPoint& b) const;

  /// From a point within the bounds towards one outside, least over some columns: at least one of
  /// those that are negative there becomes zero, and the square does not grow.
  BoundedPoint step(const BoundedPoint& from, const Eigen::VectorXd& least) const;

 private:
  Eigen::VectorXd beyond(const BoundedPoint& point, double share) const;
  double share(const BoundedPoint& from, const Eigen::VectorXd& least, Eigen::Index j) const;
  BoundedPoint step_to_first(const BoundedPoint& from, const Eigen::VectorXd& least,
                             double first) const;

  const Eigen::SparseMatrix<double>& A_;
  Eigen::SparseMatrix<double> sizes_;
  const Eigen::VectorXd& b_;
  const std::vector<bool>& free_;
};

}  // namespace camlaw::optim
