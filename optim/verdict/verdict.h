// SPDX-License-Identifier: MIT
#pragma once

#include "optim/verdict/assessment.h"
#include "optim/verdict/kkt.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/subdivision.h"

/// How a design is judged, whatever a solver says of it.
namespace camlaw::optim {

/// Whether the conditions of optimality hold: what the residual may be.
inline constexpr double kKktTolerance = 1e-7;

/// Whether a violation is the least that there is, where limits are not known to be convex.
inline constexpr double kLeastViolationTolerance = 1e-3;

/// Judges a design as an answer to the problem, with tolerances as they are at the design
/// (judged_at). `prove` asks for interval proofs over the cycle, for an answer; without, a design
/// that passes is Feasible at best. A design that passes a limit
/// is Failed here: whether the problem is infeasible is seen at the design of least violation only.
/// `told`: as of kkt().
Assessment assess(const Problem& problem, const Scales& scales, Design x, bool prove,
                  const Teller& told = {});

/// The same without proofs and without the conditions of optimality, for a design on which no more
/// time is to be spent: Feasible where every limit is met as far as was looked.
Assessment assess_in_haste(const Problem& problem, const Scales& scales, Design x);
/// Takes every size to be 1 but those of the variables, which limits' tolerances depend on.
Assessment assess_in_haste(const Problem& problem, Design x);

/// What a lower bound from dividing the box adds to the assessment of a design within the limits,
/// which was asked for with proofs. The bound that is tighter counts.
void take_subdivision(const Problem& problem, const Scales& scales, const Subdivision& division,
                      Assessment& assessment);

/// Judges a design as the one whose largest violation is least: Infeasible, with the limits to
/// blame, where the conditions for that hold.
Assessment assess_least_violation(const Problem& problem, const Scales& scales, Design x,
                                  const Teller& told = {});

/// Strict weak order: a feasible design before others, among those the better objective; of others
/// the smaller violation (what is not a number counts as infinite).
bool better(const Problem& problem, const Assessment& a, const Assessment& b);

}  // namespace camlaw::optim
