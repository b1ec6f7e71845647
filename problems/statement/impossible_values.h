// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {

/// "geneva is not possible with these values: slots = 2; slots must be 3 or more": why there is no
/// machine of the statement's values. Empty where there is one, and where its condition has no
/// words.
std::string why_impossible(const ProblemStatement& statement);

/// Adds that to the reason of a search that found no design, where it ends at such values; and to
/// that of one which ended next to them, without proof, the condition that fails there.
void say_impossible(const BoundProblem& bound, optim::Optimum& optimum);

}  // namespace camlaw::problems
