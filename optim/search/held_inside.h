// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// Takes a design into the set where the model has numbers; a design of that set stays as it is.
using IntoDomain = std::function<std::vector<double>(Design)>;

/// The problem with each response asked at into(x) in place of x: a solver that tries a design
/// outside gets numbers there, and limits on how far it may go lead it back. Linear functions stay
/// as they are; of the others nothing is known to be convex any more.
Problem held_inside(Problem problem, const IntoDomain& into);

}  // namespace camlaw::optim
