// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/verdict/conditions.h"

namespace camlaw::optim {

/// The design and where its variables stand among the rows of the conditions.
struct SecondOrderPoint {
  const Problem& problem;
  const Scales& scales;
  Design x;
  const Layout& layout;
};

/// Second derivatives of the Lagrangian over the objective's size, by typical changes, with the
/// term of each peak that moves.
Eigen::SparseMatrix<double> lagrangian_hessian(const SecondOrderPoint& point,
                                               const std::vector<ActiveLimit>& limits,
                                               const std::vector<double>& multipliers);

/// What the second derivatives tell of the directions that pass no active limit to first order.
struct SecondOrder {
  /// The Lagrangian curves downwards (by more than 1e-6 of its second derivatives) along none of
  /// them: the necessary condition of second order. False as well where that could not be shown.
  bool holds = false;
  /// Where it curves neither way, by typical changes, of length one: higher orders decide. Each may
  /// be taken both ways. Empty for more than 300 variables.
  std::vector<Eigen::VectorXd> flat;
};

/// Limits that push are kept; those that are met without pushing may be kept or left. A peak that
/// moves with the design adds its term (docs/optimisation.md, "Second order").
SecondOrder second_order(const SecondOrderPoint& point, const std::vector<ActiveLimit>& limits,
                         const std::vector<double>& multipliers);

}  // namespace camlaw::optim
