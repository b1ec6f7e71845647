// SPDX-License-Identifier: MIT
#include "problems/statement/default_machine.h"

#include <filesystem>

#include "machines/registry.h"
#include "numerics/text/names.h"

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
  if (named != nullptr) return default_machine(*named);
  std::error_code ignored;
  constexpr const char* kStandardInput = "-";
  if (name_or_file != kStandardInput && !std::filesystem::exists(name_or_file, ignored)) {
    std::vector<std::string> known;
    for (const Mechanism& mechanism : mechanisms()) known.push_back(mechanism.name);
    refuse_name("there is neither a mechanism nor a problem file", name_or_file, known,
                "'camlaw mechanisms' lists the mechanisms");
  }
  return read_problem_file(name_or_file);
}

}  // namespace camlaw::problems
