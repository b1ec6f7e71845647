// SPDX-License-Identifier: MIT
#include "problems/fits/constants_question.h"

#include "problems/statement/standard_machine.h"

namespace camlaw::problems {

ProblemStatement law_alone() { return standard_machine(find_mechanism("law")); }

}  // namespace camlaw::problems
