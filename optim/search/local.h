// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/problem/deadline.h"
#include "optim/problem/problem.h"
#include "optim/search/optimise.h"
#include "optim/search/trail.h"

/// Search in the continuous variables of one problem.
namespace camlaw::optim {

/// Searches from one or several starts, proves the best design over the cycle, and where no design
/// meets the limits looks for the one of least violation. Once the deadline has passed, the best
/// design of those that were found is judged in haste, and the reason says so. Integer variables
/// count as continuous; fix them by equal bounds. Never throws what the model throws: that is a
/// failed assessment. `known`:
/// what searches from the first starts have come to elsewhere; the others are made here.
Found search_continuous(const Problem& problem, const OptimiseOptions& options,
                        const Deadline& deadline, Depth depth, std::vector<FromStart> known = {});

/// From how many starts search_continuous() searches, unless one of them ends the search.
int planned_starts(const Problem& problem, const OptimiseOptions& options);
/// The search from one of them, counted from 0, by itself. `first`: what it knows of the first.
FromStart search_one_start(const Problem& problem, const OptimiseOptions& options,
                           const Deadline& deadline, int start, FirstStart first);

/// What is said of a design on which a search was cut short.
Found cut_short(const Problem& problem, const std::vector<double>& x, const std::string& why);

}  // namespace camlaw::optim
