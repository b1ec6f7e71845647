// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "optim/verdict/kkt.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/subdivision.h"

/// What a design is worth, whatever a solver says of it.
namespace camlaw::optim {

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
  double multiplier = 0;  ///< objective gained per unit by which that bound is relaxed
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

/// Whether the conditions of optimality hold: what the residual may be.
inline constexpr double kKktTolerance = 1e-7;

/// Judges a design as an answer to the problem, with tolerances as they are at the design
/// (judged_at). `prove` asks for interval proofs over the cycle, for an answer; without, a design
/// that passes is Feasible at best. A design that passes a limit
/// is Failed here: whether the problem is infeasible is seen at the design of least violation only.
Assessment assess(const Problem& problem, const Sizes& sizes, Design x, bool prove);

/// The same without proofs and without the conditions of optimality, for a design on which no more
/// time is to be spent: Feasible where every limit is met as far as was looked.
Assessment assess_in_haste(const Problem& problem, const Sizes& sizes, Design x);

/// What a lower bound from dividing the box adds to the assessment of a design within the limits,
/// which was asked for with proofs. The bound that is tighter counts.
void take_subdivision(const Problem& problem, const Sizes& sizes, const Subdivision& division,
                      Assessment& assessment);

/// Judges a design as the one whose largest violation is least: Infeasible, with the limits to
/// blame, where the conditions for that hold.
Assessment assess_least_violation(const Problem& problem, const Sizes& sizes, Design x);

/// Whether a design meets every limit of an assessment, and its objective is a number.
bool is_feasible(const Assessment& assessment);

/// Whether a design meets every limit and the conditions of optimality hold there.
bool is_settled(const Assessment& assessment);

/// Strict weak order: a feasible design before others, among those the better objective; of others
/// the smaller violation (what is not a number counts as infinite).
bool better(const Problem& problem, const Assessment& a, const Assessment& b);

}  // namespace camlaw::optim
