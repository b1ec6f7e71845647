// SPDX-License-Identifier: MIT
#pragma once

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// Refuses an index drive whose cams would not meet the next cycle as they met this one: too few or
/// the wrong rollers for what the motion advances by, or such a number that varies. Throws
/// std::invalid_argument.
void check_advancing_cycle(const ProblemStatement& problem);

}  // namespace camlaw::problems
