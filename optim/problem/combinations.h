// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// How many combinations of options there are. Throws std::invalid_argument for a choice without
/// options and for more than kMostCombinations.
std::size_t combinations_of(const std::vector<Choice>& choices);

}  // namespace camlaw::optim
