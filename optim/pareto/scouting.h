// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/sweep.h"

namespace camlaw::optim {

/// Designs that NSGA-II has found, of each part.
using Scouted = std::vector<std::vector<FrontPoint>>;

/// Whether every search of a sweep has one optimum, whatever its bounds.
bool searches_are_convex(const Problem& multi);

/// Looks at combinations with NSGA-II, where that is asked for or may help; where its plug-in is
/// not there the automatic method takes a sample instead, and the front's remark says so.
Scouted scout_parts(Sweep& sweep);

/// Chooses designs to begin with: the best for each objective of those that were found in a part.
std::vector<std::vector<double>> starts_of(const std::vector<FrontPoint>& found);

/// Makes searches for better designs, from as many as points are wanted.
std::vector<Task> polishing_tasks(const Scouted& scouted, const Sweep& sweep);

/// Makes searches from designs that show that a search was stuck, no more than `most`.
std::vector<Task> tasks_where_stuck(const Scouted& scouted, const Sweep& sweep, std::size_t most);

}  // namespace camlaw::optim
