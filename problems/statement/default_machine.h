// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// A machine with its default sizes: no law or program moves it yet, nothing varies.
ProblemStatement default_machine(const Mechanism& mechanism);

/// A machine as people ask for it: the name of a mechanism, at its default sizes, or a problem
/// file. Throws std::invalid_argument as read_problem_file does.
ProblemStatement asked_machine(const std::string& name_or_file);

}  // namespace camlaw::problems
