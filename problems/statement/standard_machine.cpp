// SPDX-License-Identifier: MIT
#include "problems/statement/standard_machine.h"

#include <algorithm>

#include "machines/registry.h"

namespace camlaw::problems {

ProblemStatement standard_machine(const Mechanism& mechanism) {
  ProblemStatement machine;
  machine.mechanism = &mechanism;
  for (const MechanismParameter& p : mechanism.parameters) machine.constants.push_back(p.standard);
  return machine;
}

ProblemStatement asked_machine(const std::string& name_or_file) {
  const auto& known = mechanisms();
  const auto named = std::find_if(known.begin(), known.end(),
                                  [&](const Mechanism& m) { return m.name == name_or_file; });
  return named != known.end() ? standard_machine(*named) : read_problem_file(name_or_file);
}

}  // namespace camlaw::problems
