// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "optim/problem/problem.h"
#include "optim/search/local.h"

/// Integer variables: enumeration, or branch and bound over the continuous rest.
namespace camlaw::optim {

/// A design with integer values that meets the limits, as far as is seen without a proof.
struct IntegerDesign {
  std::vector<double> x;
  double objective;
  int starts = 0, agreed = 0;  ///< as in Found
};

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
  /// Of what was not enumerated: whether a local search in every combination one step away from the
  /// best in one integer variable, and in two at once, led to none that is better.
  bool neighbours_tried = false;
  std::vector<IntegerDesign> designs = {};  ///< all, in the order in which they were found

  /// Counts what came of one continuous problem, the integer variables held or not, and keeps the
  /// best design whose integer variables have integer values.
  void add(const Problem& continuous, const Found& of);
  /// The same of one combination of those that are all tried.
  void add_combination(const Problem& fixed, const Found& of);
};

/// The values of the integer variables in all their combinations, from the start's outwards; none
/// where these are too many to try each. Without integer variables there is one without values.
std::optional<std::vector<std::vector<double>>> integer_combinations(const Problem& problem);
/// The problem with the integer variables held at these values.
Problem with_integers(const Problem& problem, const std::vector<double>& values);

/// Solves over the integer variables of one problem by branch and bound; the best is not proved
/// yet. Where bounds do not settle it, steps of the integer variables from the best design, one or
/// two at once, are taken as long as they lead to a better one.
IntegerOutcome search_tree(const Problem& problem, const OptimiseOptions& options,
                           const Deadline& deadline);

/// The problem with each integer variable fixed at the design's value.
Problem with_integers_fixed(const Problem& problem, Design x);

}  // namespace camlaw::optim
