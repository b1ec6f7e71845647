// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/fault_fit.h"
#include "fitting/motions/fitted_cycle.h"

/// From a record of a motion, with its faults, to the laws behind it.
namespace camlaw::problems {

struct RecordedMotion {
  MotionRecord record;  ///< without the rows that were left out
  FittedCycle cycle;
  std::vector<FaultTest> faults;      ///< that are seen in what the laws leave
  std::optional<Centre> centre = {};  ///< where it was asked for, in the samples' unit
};

struct RecordedMotionOptions {
  LawFitOptions fit = {};
  bool fit_centre = false;
};

/// Leaves out faulty rows (but under a loss, which bounds what they count), fits the centre if that
/// is asked for, divides the record and fits each motion; says of each why it should not be trusted
/// where the record as a whole shows a fault. Throws std::invalid_argument: fewer than five
/// samples, a centre of what is not a lift over a whole turn, and what find_motions and fit_cycle
/// throw.
RecordedMotion fit_recorded_motion(MotionRecord record, const std::vector<Member>& laws,
                                   const RecordedMotionOptions& options = {});

/// Tells every motion of a cycle not to be trusted for a fault of the record, but those that are
/// unfinished, which have their own reason.
void distrust_all(FittedCycle& cycle, const std::string& why);
/// Tells every motion not to be trusted for laws that were not tried on the way to it.
void distrust_untried(FittedCycle& cycle, const std::vector<std::string>& names);
/// Whether each motion was given the time for every law. Else what the laws leave shows no fault.
bool are_tried(const FittedCycle& cycle);
/// Whether another law than one without coefficients, or none that is trusted, was found: what a
/// fault would make of plain laws.
bool is_doubtful(const FittedCycle& cycle);
/// Intervals of the laws' numbers with the error of the centre that was taken out.
void widen_all(FittedCycle& cycle, const PossibleFault& centre, const Centre& by);
/// The laws that were tried for each motion that is finished, and its samples: of others a law that
/// is not behind them may leave what looks like a fault.
RankedMotions ranked_motions(const FittedCycle& cycle);
/// test_fault() of each.
std::vector<FaultTest> tested(const RankedMotions& motions, std::vector<PossibleFault> faults);

}  // namespace camlaw::problems
