// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "numerics/linear/program_sides.h"

namespace camlaw::optim {

/// Of a Newton step: how far the variables go, what rows and variables change by (by rows of
/// ProgramSides: rows . y, then y), and what the equations' multipliers change by.
struct NewtonStep {
  Eigen::VectorXd y, changes, w;
};

/// The linear system of an interior-point step, once its slacks and multipliers are eliminated:
///
///   curvature y + R^T (push + W R y) + E^T w = slope,   E y = demand,
///
/// R the rows, then one for each variable, and W a weight for each of them (docs/optimisation.md,
/// (XM3) and (XM5)).
class NewtonSystem {
 public:
  virtual ~NewtonSystem() = default;
  /// Whether the system with these weights by row could be factored.
  virtual bool factor(const Eigen::VectorXd& weights) = 0;
  virtual NewtonStep solve(const Eigen::VectorXd& slope, const Eigen::VectorXd& push,
                           const Eigen::VectorXd& demand) const = 0;
};

/// By Cholesky's factors of the variables' system, curvature + R^T W R, which is small and squares
/// the condition of the rows.
std::unique_ptr<NewtonSystem> normal_equations(const ProgramSides& sides);

/// By pivoted factors of variables and rows together, whose condition is that of the rows: what the
/// rows push with, W R y + push, are unknowns too. None where these are not local, so that the
/// factors would be full.
std::unique_ptr<NewtonSystem> augmented_system(const ProgramSides& sides);

}  // namespace camlaw::optim
