// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "problems/statement/statement.h"

/// Curves that run over a range of speeds, in rpm, and not over the cycle: curves_of has the
/// others.
namespace camlaw::problems {

inline bool is_over_speed(const MechanismResponse& response) { return response.along == "rpm"; }

/// Those of the mechanism at the statement's starts.
std::vector<optim::Response> curves_over_speed(const ProblemStatement& statement);

}  // namespace camlaw::problems
