// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/optimum_output.h"

/// Curves over the cycle as pictures and tables.
namespace camlaw::cli {

/// Every curve that the problem limits or seeks, over the cycle, with its limits.
Figure cycle_figure(const Answer& answer);

/// Points that a curve over the cycle is drawn with.
inline constexpr int kCyclePoints = 720;

/// Every curve of the mechanism at the design that a statement begins with.
/// Where the peaks of curves are known, as `evaluated` says, they are not looked for again.
Figure curves_figure(const problems::ProblemStatement& statement, int points = kCyclePoints,
                     const std::vector<problems::EvaluatedResponse>& evaluated = {});

/// Draws a statement's limits into the panels of the curves that they hold.
void draw_limits(const problems::ProblemStatement& statement, Figure& figure);

/// The same as CSV: the place, then a column for each curve, "follower_force [N]"; `steps` + 1 even
/// places of the cycle, where a curve jumps its value behind the jump.
std::string curves_csv(const problems::ProblemStatement& statement, int steps);

}  // namespace camlaw::cli
