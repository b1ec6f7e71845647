// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/verdict/conditions.h"

namespace camlaw::optim {

/// The design and where its variables stand among the rows of the conditions.
struct SecondOrderPoint {
  const Problem& problem;
  const Sizes& sizes;
  Design x;
  const Layout& layout;
};

/// Second derivatives of the Lagrangian over the objective's size, by typical changes, with the
/// term of each peak that moves.
Eigen::SparseMatrix<double> lagrangian_hessian(const SecondOrderPoint& point,
                                               const std::vector<ActiveLimit>& limits,
                                               const std::vector<double>& multipliers);

/// Whether the Lagrangian's second derivatives are nowhere negative (to 1e-6 of their size) along
/// the directions that keep every active limit: the necessary condition of second order. A peak
/// that moves with the design adds its term (docs/optimisation.md, "Second order").
bool second_order_holds(const SecondOrderPoint& point, const std::vector<ActiveLimit>& limits,
                        const std::vector<double>& multipliers);

}  // namespace camlaw::optim
