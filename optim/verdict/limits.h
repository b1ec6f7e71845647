// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/cycle/extremes.h"
#include "optim/cycle/scales.h"
#include "optim/verdict/assessment.h"

/// Where a design stands against each limit. Written from the problem alone: the functions
/// themselves and the search for their peaks are shared with what feeds the solvers, the proof is
/// not.
namespace camlaw::optim {

/// Every constraint at x; where a proof finds a limit passed, at that angle. `prove` asks for the
/// interval proofs as well.
std::vector<LimitReport> limit_reports(const Problem& problem, const Scales& scales, Design x,
                                       bool prove);

/// Turns the report of a limit with two bounds, at x, to one of them: value, bound, margin, place.
void show_side(const Constraint& constraint, Design x, bool upper, LimitReport& report);

/// The objective at x.
ObjectiveReport objective_report(const Problem& problem, const Scales& scales, Design x,
                                 bool prove);

/// What of objective and constraints is not a finite number at x, with the reason where one is
/// known: "the model gives no number: C is infinite: it has a pulse at 0.5"; `where` ends the first
/// words.
std::string undefined_at(const Problem& problem, Design x, const std::string& where);

/// Largest violation over its tolerance: at most 1 for a design that meets every limit; infinite
/// where something is not a number.
double worst_violation(const std::vector<LimitReport>& limits);

}  // namespace camlaw::optim
