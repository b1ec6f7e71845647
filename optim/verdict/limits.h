// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optim/cycle/extremes.h"
#include "optim/cycle/sizes.h"

/// Where a design stands against each limit. Written from the problem alone: the functions
/// themselves and the search for their peaks are shared with what feeds the solvers, the proof is
/// not.
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
  bool met = false;       ///< margin >= -tolerance
  bool proved = false;    ///< by intervals: over the whole cycle, rounding included
  double multiplier = 0;  ///< objective gained per unit by which the bound is relaxed
  /// It pushes at a rest, where it vanishes whatever the design: what easing it gains there has no
  /// price, and is not counted in the multiplier.
  bool at_rest = false;
};

/// Every constraint at x; where a proof finds a limit passed, at that angle. `prove` asks for the
/// interval proofs as well.
std::vector<LimitReport> limit_reports(const Problem& problem, const Sizes& sizes, Design x,
                                       bool prove);

/// Turns the report of a limit with two bounds, at x, to one of them: value, bound, margin, place.
void show_side(const Constraint& constraint, Design x, bool upper, LimitReport& report);

/// The objective at x and, of a curve, where its peak is.
struct ObjectiveReport {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> angle;
  bool from_left = false;
  double sign = 1;       ///< -1 where the peak is one of the negative curve
  Bounds proved;         ///< the exact value lies between; infinite where there is no enclosure
  double tolerance = 0;  ///< a difference up to this counts as none
};
ObjectiveReport objective_report(const Problem& problem, const Sizes& sizes, Design x, bool prove);

/// What of objective and constraints is not a finite number at x, with the reason where one is
/// known: "the model gives no number: C is infinite: it has a pulse at 0.5"; `where` ends the first
/// words.
std::string undefined_at(const Problem& problem, Design x, const std::string& where);

/// Largest violation over its tolerance: at most 1 for a design that meets every limit; infinite
/// where something is not a number.
double worst_violation(const std::vector<LimitReport>& limits);

}  // namespace camlaw::optim
