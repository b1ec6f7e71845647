// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "optim/problem/function.h"

/// What a design is worth, whatever a solver says of it.
namespace camlaw::optim {

/// One constraint at a design. Numbers are in the response's unit.
struct LimitReport {
  std::string name, unit;
  double value = 0;  ///< of a curve: at the angle that is worst for the side named below
  double bound = 0;  ///< the nearer one, or the one passed by more
  bool is_upper = true;
  double margin = 0;  ///< to the bound; negative where it is passed
  double tolerance = 0;
  std::optional<double> worst_angle;  ///< of a curve
  bool from_left = false;             ///< the side of a break that it stands at
  bool is_equation = false;
  bool met = false;     ///< margin >= -tolerance
  bool proved = false;  ///< by intervals: over the whole cycle, rounding included
  /// Where a proof was given up: of a curve the stretch of the cycle, of a number without bounds.
  std::optional<Bounds> left = {};
  /// Objective gained per unit by which the bound is relaxed; NaN where no price is known.
  double multiplier = 0;
  /// It pushes at a rest, where it vanishes whatever the design: what easing it gains there has no
  /// price, and is not counted in the multiplier.
  bool at_rest = false;
};

/// The objective at a design and, of a curve, where its peak is.
struct ObjectiveReport {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> angle;
  bool from_left = false;
  double sign = 1;       ///< -1 where the peak is one of the negative curve
  Bounds proved;         ///< the exact value lies between; infinite where there is no enclosure
  double tolerance = 0;  ///< a difference up to this counts as none
};

enum class Verdict {
  Certified,   ///< meets every limit, proved over the cycle, and the conditions of optimality hold
  Feasible,    ///< meets every limit; that nothing near is better is not shown
  Infeasible,  ///< no design near meets all limits: the least-violating one, and who is to blame
  Failed,      ///< no answer; the reason says why
};
std::string_view to_string(Verdict verdict);

struct VariableReport {
  std::string name, unit;
  double value = 0;
  double lower = -kInfinity, upper = kInfinity;
  bool at_lower = false, at_upper = false;
  /// Objective gained per unit by which that bound is relaxed; NaN where no price is known.
  double multiplier = 0;
};

struct Assessment {
  Verdict verdict = Verdict::Failed;
  std::string reason;
  ObjectiveReport objective;
  std::vector<VariableReport> variables;
  std::vector<LimitReport> limits;
  double kkt_residual = kInfinity;
  double condition = 1;  ///< of the active limits' gradients; infinite: they depend on each other
  bool second_order = false;
  bool is_global = false;           ///< by the shapes, if the conditions hold
  bool at_moving_break = false;     ///< a pushing peak stands at a joint that moves with the design
  std::vector<std::string> active;  ///< limits and bounds that the design stands at, by name
  std::vector<std::string> blamed;  ///< where infeasible: the limits that contradict one another
  std::optional<std::string> global;  ///< why no better design exists anywhere; empty: not shown
  /// What no design that meets every limit is better than, from a lower bound that does not rest on
  /// the conditions of optimality; empty where none is known.
  std::optional<double> best_possible;
  /// What makes the conditions of optimality doubtful though they hold, in words: a limit whose own
  /// tolerance would change the objective.
  std::string sign;
  double objective_measure = 1;  ///< what changes of the objective are a share of, in its unit
};

struct Problem;

/// Whether a design meets every limit of an assessment and the bounds of its variables.
bool meets_limits(const Assessment& assessment);

/// The same, and its objective is a number.
bool is_feasible(const Assessment& assessment);

/// Whether a design meets every limit, and the conditions of optimality hold there or a lower bound
/// leaves nothing better.
bool is_settled(const Assessment& assessment);

/// Whether a design's objective is within 1e-4 of what theory says that no design passes
/// (Objective::limit).
bool is_near_limit(const Problem& problem, const Assessment& assessment);

}  // namespace camlaw::optim
