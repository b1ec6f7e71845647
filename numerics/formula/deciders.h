// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/formula/formula.h"

namespace camlaw {

/// What a formula decides by: where one of these, functions of the same inputs, changes its sign
/// the formula may have a kink or jump, and nowhere else but at poles. None of a formula that
/// searches for roots.
std::vector<Formula> deciders(const Formula& formula);

/// Those at which it may jump: what chooses between two numbers, or gives one a sign.
std::vector<Formula> jump_deciders(const Formula& formula);

/// Those formulas that use an input from `first` on.
std::vector<Formula> moving(std::vector<Formula> formulas, std::size_t first);

}  // namespace camlaw
