// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// Adds a limit of validity, where the problem has none as tight.
void add_validity(const ValidityLimit& limit, const std::string& required_by,
                  ProblemStatement& problem);

/// Adds the mechanism's own limits of validity, and takes away those of a part that the machine
/// does not have with the values of now: the parameter that brings it is 0 everywhere.
void limit_to_validity(ProblemStatement& problem);

}  // namespace camlaw::problems
