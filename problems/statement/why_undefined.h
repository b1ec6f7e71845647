// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/statement/bind.h"

namespace camlaw::problems {

/// Why a response of the statement's starts is not a number, of a curve why it has none everywhere,
/// where that is known; else empty, as of a response that is one.
std::string why_undefined(const ProblemStatement& statement, const EvaluatedResponse& response);

}  // namespace camlaw::problems
