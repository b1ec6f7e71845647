// SPDX-License-Identifier: MIT
#include "fitting/constants/constants_question.h"

#include "machines/registry.h"
#include "problems/statement/default_machine.h"

namespace camlaw::problems {

ProblemStatement law_alone() { return default_machine(find_mechanism("law")); }

}  // namespace camlaw::problems
