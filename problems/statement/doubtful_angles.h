// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// Of each program of a problem file whose angles are plain numbers that together are at most a
/// turn in radians: what to say of them. As degrees they would be a few hundredths of the cycle.
std::vector<std::string> doubtful_angles(const ProblemStatement& problem);

}  // namespace camlaw::problems
