// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/statement/statement.h"

namespace camlaw::python {

/// The statement with these names as its only variables, all of them continuous, and with the first
/// of its laws: a function of so many numbers. Names are variables, constants and parameters of the
/// law. Throws std::invalid_argument for others.
problems::ProblemStatement with_variables(problems::ProblemStatement statement,
                                          const std::vector<std::string>& names);

}  // namespace camlaw::python
