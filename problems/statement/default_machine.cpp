// SPDX-License-Identifier: MIT
#include "problems/statement/default_machine.h"

#include "machines/registry.h"

namespace camlaw::problems {

ProblemStatement default_machine(const Mechanism& mechanism) {
  ProblemStatement machine;
  machine.mechanism = listed(mechanism);
  for (const MechanismParameter& p : mechanism.parameters)
    machine.constants.push_back(p.default_value);
  return machine;
}

ProblemStatement asked_machine(const std::string& name_or_file) {
  const Mechanism* named = known_mechanism(name_or_file);
  return named != nullptr ? default_machine(*named) : read_problem_file(name_or_file);
}

}  // namespace camlaw::problems
