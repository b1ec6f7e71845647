// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// Throws std::invalid_argument where the file leaves the knots of its free law to be found
/// (refinement/refined_knots.h): what is asked for, "a front", has no one law to find them for.
void refuse_auto_knots(const ProblemStatement& statement, const std::string& what);

}  // namespace camlaw::problems
