// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optim/cycle/scales.h"
#include "optim/problem/function.h"

/// Conditions of optimality (Karush, Kuhn, Tucker) at a design, from the problem alone
/// (docs/optimisation.md, "Conditions of optimality").
namespace camlaw::optim {

/// What the conditions are checked for: the objective's optimum, or the least of the largest
/// violation (counted in the constraints' scales).
enum class Optimality { Objective, LeastViolation };

/// A limit that holds a design, with its multiplier, as a sharp method (Solver::is_sharp) tells it.
/// Only the choice of limits and their prices are its word: what they are worth, the conditions
/// say.
struct Push {
  std::optional<std::size_t> constraint, variable;  ///< neither: the objective's peak
  std::optional<Function> function;                 ///< of the problem; none for a variable's bound
  double sign = 1;                                  ///< 1 the upper bound, -1 the lower one
  double size = 1;                                  ///< in the response's unit
  bool at_rest = false;
  /// Objective gained per unit of the bound, not negative; of an equation of either sign.
  double price = 0;
  /// By which the function is found again (functions_of): the place on a curve, or the number of
  /// the rest; neither: the limit is one of a number.
  std::optional<Place> place = {};
  std::optional<std::size_t> rest = {};
};

/// Asked for pushes where they are needed: to find them may take a search.
using Teller = std::function<std::vector<Push>()>;

/// Tells these; nothing to tell where there are none.
Teller told_as(const std::vector<Push>& pushes);

struct Kkt {
  /// Largest entry of the Lagrangian's gradient, by the variables' own magnitudes, and what
  /// multipliers times margins leave open; over the objective's measure: the larger of its value
  /// and a tenth of its typical change (of LeastViolation: over the violation).
  double residual = kInfinity;
  /// Objective units gained per unit of the bound, not negative; of an equation signed: by how much
  /// the objective rises as the bound does. Of LeastViolation: shares that add up to one, by size.
  std::vector<double> constraints;
  /// Of a limit with two bounds the side that pushes: 1 the upper one, -1 the lower one, 0 neither.
  std::vector<int> pushing_sides;
  std::vector<double> lower, upper;  ///< of the variables' bounds
  std::vector<bool> active_constraints, active_lower, active_upper;
  /// Of the active limits' gradients; infinite: multipliers that are not unique; not a number where
  /// it was not worked out.
  double condition = 1;
  double objective_slope = 0;  ///< its largest entry, over the objective's size
  bool flat = false;  ///< LeastViolation: a limit that pushes is stationary and not known convex
  /// A peak that pushes stands at a break that moves with the design: its gradient is not known.
  bool at_moving_break = false;
  bool second_order = false;  ///< no direction along the active limits improves, to second order
  /// By how much any design within the limits may be better at most; none where it is not known.
  std::optional<double> largest_gain = {};
  /// Limits that push at a rest, where they vanish: they have no price.
  std::vector<bool> at_rest;
  /// What easing every limit that pushes by its own tolerance gains, over the objective's measure.
  double gain_of_tolerances = 0;
};

/// Whether the shapes make a design where the conditions hold the best there is. A quasiconvex
/// objective must slope there.
bool is_global_valley(const Problem& problem, double objective_slope);

/// At a design that meets every limit (for LeastViolation: any design). Of many variables the
/// multipliers that are told are tried before others are looked for, of few where none were found
/// with which the conditions hold. Told ones come without their condition where it is not wanted.
Kkt kkt(const Problem& problem, const Scales& scales, Design x,
        Optimality optimality = Optimality::Objective, const Teller& told = {},
        bool wants_condition = true);

}  // namespace camlaw::optim
