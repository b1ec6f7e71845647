// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "optim/verdict/kkt.h"

/// The limits that a design stands at, with their gradients.
namespace camlaw::optim {

/// One limit, turned so that its multiplier is not negative: what grows where it is passed. Over
/// the objective's or the constraint's size and by the variables' typical changes.
struct ActiveLimit {
  std::vector<std::pair<std::size_t, double>> gradient;  ///< by design variables
  double auxiliary = 0;  ///< by the peak's bound or the violation, where there is one
  double margin = 0;     ///< to the limit, in the same measure
  double size = 1;       ///< of the response
  double sign = 1;
  bool is_equation = false;
  std::optional<std::size_t> constraint, variable;  ///< neither: the objective's peak
  std::optional<Function> function;                 ///< none for a variable's bound
  /// Of an inner peak: the slope by the angle, derived by the design (Curve::slope_gradient), and
  /// the curvature there.
  std::vector<double> slope_gradient;
  double curvature = 0;
  /// A peak at a break that moves with the design, and the curve slopes there: the gradient along
  /// with the break is not known.
  bool at_moving_break = false;
};

/// The limits whose margin is at most `width`, a share of their size, or twice their tolerance.
std::vector<ActiveLimit> active_limits(const Problem& problem, const Sizes& sizes, Design x,
                                       Optimality optimality, double width);

}  // namespace camlaw::optim
