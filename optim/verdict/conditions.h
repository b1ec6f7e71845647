// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "optim/verdict/active.h"

/// The conditions of optimality as a linear system for the multipliers.
namespace camlaw::optim {

/// The rows of the conditions: one for each variable that is free, one for the peak's bound or the
/// violation where there is one.
struct Layout {
  std::vector<int> row;  ///< of each variable; -1 where it is fixed
  int rows = 0;
  int auxiliary = -1;
};
Layout lay_out(const Problem& problem, Optimality optimality);

/// The objective's gradient, over its size and by typical changes.
Eigen::VectorXd objective_gradient(const Problem& problem, const Scales& scales, Design x,
                                   const Layout& layout);

/// What changes of the objective are measured by, over its scale (objective_size).
double objective_measure(const Problem& problem, const Scales& scales, Design x);

/// Limits near a design and the multipliers with which the conditions hold best.
struct Weighed {
  std::vector<ActiveLimit> limits;
  std::vector<double> multipliers;  ///< by limit, over the scales
  double residual = kInfinity;
  double condition = 1;  ///< not a number where it was not wanted
};

/// Of the limits in the net.
Weighed weigh(const Problem& problem, const Scales& scales, Design x, Optimality optimality,
              const Layout& layout, Net net);
/// With the multipliers that were told, or where that is better with those fitted once more to the
/// conditions, where they are to be. The condition, which takes as long as all the rest, comes only
/// where it is wanted.
Weighed weigh(const Problem& problem, const Scales& scales, Design x, Optimality optimality,
              const Layout& layout, const std::vector<Push>& pushes, bool are_fitted,
              bool wants_condition);

/// A multiplier that was told and is no more than this share of the largest says nothing of its
/// limit: an interior-point method leaves some to all.
inline constexpr double kIdle = 1e-9;

}  // namespace camlaw::optim
