// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/constants/printed_constants.h"
#include "problems/statement/statement.h"

namespace camlaw::problems {

/// What is asked of printed constants: the machine with what is known of it, and what is printed.
struct ConstantsQuestion {
  /// Mechanism and constants. Its variables that belong to the mechanism are unknown within their
  /// bounds; objectives and constraints do not matter. Its stop flag ends the search for an answer.
  ProblemStatement machine;
  std::vector<PrintedConstant> constants;
};

/// The machine that is a law alone.
ProblemStatement law_alone();

}  // namespace camlaw::problems
