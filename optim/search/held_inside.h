// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// Takes a design into the set where the model has numbers; a design of that set stays as it is.
using IntoDomain = std::function<std::vector<double>(Design)>;

/// Of a design that is not within, one at which the line to it from a design inside leaves the set;
/// a design within stays as it is. The last design that was asked about is remembered.
IntoDomain drawn_towards(std::vector<double> inside, std::function<bool(Design)> is_within);

/// The problem with each response asked at into(x) in place of x: a solver that tries a design
/// outside gets numbers there, and limits on how far it may go lead it back. Derivatives are those
/// at into(x). Linear functions and curves stay as they are; of the others nothing is known to be
/// convex any more.
Problem held_inside(Problem problem, const IntoDomain& into);

}  // namespace camlaw::optim
