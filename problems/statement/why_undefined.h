// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/statement/bind.h"

namespace camlaw::problems {

/// Why a curve of the statement's starts has no numbers, where that is known; else empty, as of a
/// response that has some.
std::string why_undefined(const ProblemStatement& statement, const EvaluatedResponse& response);

}  // namespace camlaw::problems
