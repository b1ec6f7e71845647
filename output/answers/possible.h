// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/statement/bind.h"

namespace camlaw::cli {

/// Refuses values that leave no number at all: there is no such machine. `responses` are those of
/// the statement, `file` names it. Throws std::invalid_argument with the
/// condition that fails and the values that it is about; where none is known, with all values.
void check_possible(const std::string& file, const problems::ProblemStatement& statement,
                    const std::vector<problems::EvaluatedResponse>& responses);

}  // namespace camlaw::cli
