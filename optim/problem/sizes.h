// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/problem.h"

/// Sizes: what counts as a change of order one, for scaling and for tolerances, all in the units of
/// the problem.
namespace camlaw::optim {

struct ConstraintSize {
  double size;       ///< change of the response by typical changes of the variables
  double tolerance;  ///< a violation up to this counts as none
};

struct Sizes {
  std::vector<double> variables;  ///< typical changes (variable_scales)
  double objective;               ///< the objective's size
  double objective_tolerance;
  double objective_typical;  ///< change of the objective by typical changes, over the whole box
  std::vector<ConstraintSize> constraints;
};

/// The objective: of a curve its peak, found by search.
double objective_value(const Objective& objective, Design x);

/// The largest violation of a constraint at x, over its size; below 0 where all have room.
double largest_violation(const Problem& problem, const Sizes& sizes, Design x);

/// Sizes about a design. A response's size is the largest change that one variable's typical change
/// makes, to first order, but no less than 1e-3 of the bound; the tolerance by default 1e-6 of the
/// larger of bound (the size, where the bound is zero). A design may be unlike all others (a
/// stationary point, a pole nearby): the change is kept within a hundredth and a hundred times the
/// median of eight designs that fill the box.
Sizes sizes(const Problem& problem, Design about);

/// Largest |df/dx_i| * scale_i, of a curve over some places of the cycle; zero where it is not a
/// number.
double typical_change(const Response& response, Design x, const std::vector<double>& scales);
double typical_change(const Function& function, Design x, const std::vector<double>& scales);

}  // namespace camlaw::optim
