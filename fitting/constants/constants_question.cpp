// SPDX-License-Identifier: MIT
#include "fitting/constants/constants_question.h"

#include "machines/registry.h"
#include "problems/statement/standard_machine.h"

namespace camlaw::problems {

ProblemStatement law_alone() { return standard_machine(find_mechanism("law")); }

}  // namespace camlaw::problems
