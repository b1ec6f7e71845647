// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/task.h"

namespace camlaw::optim {

/// NSGA-II (Deb and others 2002; pagmo): `population` designs, evolved for `generations`. Limits
/// go first: of two designs that pass some the one that passes them by less is better, and any that
/// meets all is better than both. The designs of the last generation that meet every limit and that
/// no other one dominates. Integer variables stay integers. The same seed, the same designs.
Outcome scout(const Task& task, const Problem& multi);

/// Of `population` designs that fill the box evenly those that meet every limit and that no other
/// one of them dominates: used in place of scout() without NSGA-II.
Outcome sample(const Task& task, const Problem& multi);

}  // namespace camlaw::optim
