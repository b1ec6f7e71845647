// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/statement/bind.h"

namespace camlaw::problems {

/// Why a response of the statement's starts is not a number, of a curve why it has none everywhere,
/// where that is known; else empty, as of a response that is one.
std::string why_undefined(const ProblemStatement& statement, const EvaluatedResponse& response);

/// Why a curve of the statement's starts becomes infinite: "contact_force is 0 N at 12 deg", where
/// what its formula divides by has come to its bound. Empty of a curve that is finite, and where
/// nothing is known.
std::string why_infinite(const ProblemStatement& statement, const EvaluatedResponse& response);

}  // namespace camlaw::problems
