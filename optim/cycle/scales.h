// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/problem.h"

/// Scales: what counts as a change of order one, for scaling and for tolerances, all in the units
/// of the problem.
namespace camlaw::optim {

struct ConstraintScale {
  double scale;              ///< change of the response by typical changes of the variables
  double tolerance;          ///< a violation up to this counts as none
  double default_tolerance;  ///< what that would be if nothing were stated, or less
};

struct Scales {
  std::vector<double> variables;  ///< typical changes (typical_scales)
  std::vector<double> own;        ///< own magnitudes (own_magnitudes): no box makes them smaller
  double objective;               ///< the objective's scale
  double objective_tolerance;
  double objective_typical;  ///< change of the objective by typical changes about the design
  std::vector<ConstraintScale> constraints;
};

/// How large the variables of a design are: as stated by their scale, else |x|, but no less than
/// one of the unit, or than the range where that is below one. A wider box does not change it.
std::vector<double> own_magnitudes(const Problem& problem, Design x);

/// A typical change of each variable at a design: its own magnitude, but no more than the range.
std::vector<double> typical_scales(const Problem& problem, Design x);

/// The objective: of a curve its peak, found by search.
double objective_value(const Objective& objective, Design x);

/// What counts as the size of an objective: its |value| or, where that is near zero, a share of a
/// typical change, 1e-4 of a number's and a tenth of a peak's (docs/optimisation.md, (OC5)). A
/// lower bound is as good as the value where it is within 1e-6 of this.
double objective_size(const Objective& objective, double typical, double value);

/// The largest violation of a constraint at x, over its scale; below 0 where all have room.
double largest_violation(const Problem& problem, const Scales& scales, Design x);

/// Scales about a design, from the design's own magnitudes: a box that is written wider changes
/// nothing. A response's scale is the largest change that one variable's typical change makes, to
/// first order, but no less than 1e-3 of the bound. A design may be unlike its neighbours (a
/// stationary point, a pole): the change is kept within a hundredth and a hundred times the median
/// of eight designs that fill the neighbourhood, one typical change wide to each side.
///
/// Tolerances: of a limit as stated, else 1e-6 of the larger bound (of a thousandth of the
/// response's own magnitude, where that is more); where the bounds are zero, 1e-6 of the response's
/// own magnitude at the design: of a curve its highest |value|, of a number the
/// sum of |df/dx_i| times the variables' own magnitudes. Of the objective as stated, else 1e-7 of
/// its size (objective_size), of a curve of the larger of |value| and a typical change. That is no
/// more than how large the curve is there and, divided by the number of variables squared (to a
/// thousandth), about. Changes and sizes about that exceed the value tenfold are the least of those
/// in ever narrower neighbourhoods, enlarged by how much narrower they are.
Scales scales(const Problem& problem, Design about);

/// The same scales, with tolerances and own magnitudes as they are at another design.
Scales judged_at(const Problem& problem, Scales scales, Design x);

/// The same scales, but those of the limits that a design breaks are such that it breaks all of
/// them by the same share, the largest share of before. What shows that limits contradict one
/// another does so by any scales above 0: at a design of least violation by other scales than
/// these, the limits that hold it there are then among the active ones.
Scales broken_alike(const Problem& problem, Scales scales, Design x);

/// Largest |df/dx_i| * scale_i, of a curve over some places of the cycle; zero where it is not a
/// number.
double typical_change(const Response& response, Design x, const std::vector<double>& scales);
double typical_change(const Function& function, Design x, const std::vector<double>& scales);

}  // namespace camlaw::optim
