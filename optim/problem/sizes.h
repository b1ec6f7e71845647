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
  double objective_value;  ///< at the design that the sizes are about
  std::vector<ConstraintSize> constraints;
};

/// The objective: of a curve its peak, found by search.
double objective_value(const Objective& objective, Design x);

/// Sizes about a design. A response's size is the largest change that one variable's typical change
/// makes, to first order, but no less than 1e-3 of the bound; the tolerance by default 1e-6 of the
/// larger of bound (the size, where the bound is zero).
Sizes sizes(const Problem& problem, Design about);

/// Largest |df/dx_i| * scale_i, of a curve over some places of the cycle; zero where it is not a
/// number.
double typical_change(const Response& response, Design x, const std::vector<double>& scales);
double typical_change(const Function& function, Design x, const std::vector<double>& scales);

}  // namespace camlaw::optim
