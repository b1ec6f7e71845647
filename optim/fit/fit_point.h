// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "optim/fit/residuals.h"

/// One point of a fit and what it is worth to go on from there.
namespace camlaw::optim {

/// The box that the parameters stay in.
struct FitBox {
  Eigen::VectorXd lower, upper;
};

/// The residuals at p with their Jacobian.
struct FitPoint {
  Eigen::VectorXd p, r;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian;
  double rest = 0;  ///< of the residuals
  double sum() const { return r.squaredNorm(); }
  /// Of the residuals of all measurements.
  double length() const { return std::sqrt(sum() + rest); }
};

/// Nothing where the residuals are undefined.
std::optional<FitPoint> fit_point(const Residuals& residuals, Eigen::VectorXd p);

/// The Gauss-Newton step from a point within its box, (FT2) to (FT4) of docs/optimisation.md.
struct GaussNewton {
  /// Parameters that stay: their bounds are equal, or they stand at a bound and would leave.
  std::vector<bool> held;
  Eigen::VectorXd step;  ///< the shortest, by scaled columns; zero for those held
  /// |J step|: what the part of r that the model can still follow is long.
  double reduction = 0;
  double rounding = 0;    ///< what rounding of the parameters alone makes of |r|
  bool full_rank = true;  ///< of the columns that are not held
};

/// Directions that change r by less than `tolerance` of what the strongest does, by columns of
/// length one, are left out.
GaussNewton gauss_newton(const FitPoint& point, const FitBox& box, double tolerance);

/// The indexes of the parameters that are not held.
std::vector<Eigen::Index> free_parameters(const std::vector<bool>& held);

/// p + share step, as far as the first bound.
Eigen::VectorXd stepped(const FitPoint& point, const FitBox& box, const Eigen::VectorXd& step,
                        double share);

/// The share of r that the model can still follow, the cosine of (FT4); 0 where r is zero.
double followed(const FitPoint& point, const GaussNewton& step);

/// Whether that is next to nothing: at most 1e-6, or no more than rounding makes.
bool is_stationary(const FitPoint& point, const GaussNewton& step);

}  // namespace camlaw::optim
