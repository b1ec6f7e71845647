// SPDX-License-Identifier: MIT
#pragma once

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// Refuses an index drive whose cams would not meet the next cycle as they met this one: too few or
/// the wrong rollers for what the motion advances by, or such a number that varies. Throws
/// std::invalid_argument.
void check_advancing_cycle(const ProblemStatement& problem);

/// Refuses a parameter that decides whether an index drive closes: it takes one value, under
/// [constants]. The name is the machine's, of a shaft with the cam before it, "infeed.rollers".
/// Throws std::invalid_argument.
void check_may_vary(const Mechanism& mechanism, const std::string& parameter);

}  // namespace camlaw::problems
