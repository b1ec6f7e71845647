// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// Says of a design at which the conditions of optimality do not hold that the objective, a number,
/// seems to be unbounded about it, and near which values of the variables: where it is better there
/// than at the start by a million times what it is at the start or typically changes there, or
/// where it is enclosed and has no bound within a millionth of the variables' typical changes.
/// Empty where neither is so.
std::string unbounded_words(const Problem& problem, Design x);

}  // namespace camlaw::optim
