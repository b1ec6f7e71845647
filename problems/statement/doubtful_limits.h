// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/statement/bind.h"

namespace camlaw::problems {

/// Limits whose bound is more than 10^6 times as large, or as small, as the response at every
/// design that is looked at: the start, both corners and eight more places of the box. Each in a
/// sentence that says what the bound was read as; most likely its unit is wrong. A bound of zero
/// has no unit to mistake.
std::vector<std::string> doubtful_limits(const BoundProblem& bound);

}  // namespace camlaw::problems
