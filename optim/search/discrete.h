// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"
#include "optim/search/local.h"

/// Integer variables: enumeration, or branch and bound over the continuous rest.
namespace camlaw::optim {

/// What the search over integer variables came to.
struct IntegerOutcome {
  Found found;
  std::size_t combinations = 1;  ///< as a double would overflow, at most 1e18
  std::size_t solved = 0;        ///< continuous problems
  bool complete = true;          ///< every combination was solved or excluded
  std::size_t infeasible = 0;    ///< combinations, or nodes, found to have no design
  bool all_infeasible = true;    ///< every one that was looked at had none
  bool bounds_hold = true;       ///< what was excluded was excluded by convex problems
  bool enumerated = true;
};

/// Solves over the integer variables of one problem; the best is not proved yet.
IntegerOutcome search_integers(const Problem& problem, const OptimiseOptions& options,
                               const Deadline& deadline);

/// The problem with each integer variable fixed at the design's value.
Problem with_integers_fixed(const Problem& problem, Design x);

}  // namespace camlaw::optim
