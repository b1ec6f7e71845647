// SPDX-License-Identifier: MIT
#include "problems/fits/constants_question.h"

namespace camlaw::problems {

ProblemStatement law_alone() {
  ProblemStatement machine;
  machine.mechanism = &find_mechanism("law");
  for (const MechanismParameter& p : machine.mechanism->parameters) {
    machine.constants.push_back(p.standard);
  }
  return machine;
}

}  // namespace camlaw::problems
