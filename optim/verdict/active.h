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
  /// The leading coefficient of a limit that vanishes at a rest (Rest::leading): its size is not
  /// one of the response.
  bool at_rest = false;
  /// The price that a method has told of it (Push); then the design need not stand at it.
  std::optional<double> told = {};
};

/// How wide the net is cast for limits that hold a design.
struct Net {
  double width;    ///< the largest margin, a share of the limit's size
  int places = 1;  ///< of curves the even steps between the ends of a smooth stretch
};

/// The limits whose margin is at most the net's width or twice their tolerance: numbers, variables'
/// bounds, and of curves the local maxima and the ends of smooth stretches. Near a rest a limit is
/// judged divided by the power with which it vanishes there, at the rest by its leading coefficient
/// (docs/optimisation.md, "Limits that vanish"). What no variable moves is not a limit.
std::vector<ActiveLimit> active_limits(const Problem& problem, const Scales& scales, Design x,
                                       Optimality optimality, Net net);

/// The limits that were told, whatever their margin, but those that the problem does not have and
/// those that no variable moves.
std::vector<ActiveLimit> told_limits(const Problem& problem, const Scales& scales, Design x,
                                     Optimality optimality, const std::vector<Push>& told);

}  // namespace camlaw::optim
