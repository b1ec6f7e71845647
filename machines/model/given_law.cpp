// SPDX-License-Identifier: MIT
#include "machines/model/given_law.h"

#include <algorithm>
#include <utility>

namespace camlaw::problems {
namespace {

bool is_given(const Member& law, const LawVariable& variable) {
  return law.family->parameters[variable.parameter].given_by.has_value();
}

}  // namespace

std::optional<std::size_t> given_parameter(const Family& family, std::size_t machine_parameter) {
  const auto& all = family.parameters;
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Parameter& p) { return p.given_by == machine_parameter; });
  if (found == all.end()) return {};
  return static_cast<std::size_t>(found - all.begin());
}

void give(const std::vector<double>& constants, Member& law) {
  const auto& all = law.family->parameters;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].given_by) law.arguments.values()[i] = {constants[*all[i].given_by]};
  }
}

std::shared_ptr<const LawBinding> given_law(Member law, std::vector<LawVariable> variables,
                                            const Binding& machine) {
  give(machine.constants, law);
  for (std::size_t k = 0; k < machine.parameters.size(); ++k) {
    if (const auto own = given_parameter(*law.family, machine.parameters[k])) {
      variables.push_back({*own, 0, machine.variables[k]});
    }
  }
  return std::make_shared<LawBinding>(std::move(law), std::move(variables));
}

std::shared_ptr<const LawBinding> given_again(const Binding& machine) {
  if (!machine.law) return machine.law;
  const Member& law = machine.law->member();
  const auto& all = law.family->parameters;
  if (std::none_of(all.begin(), all.end(), [](const Parameter& p) { return p.given_by; })) {
    return machine.law;
  }
  std::vector<LawVariable> variables = machine.law->variables();
  std::erase_if(variables, [&](const LawVariable& v) { return is_given(law, v); });
  return given_law(law, std::move(variables), machine);
}

Mechanism giving_law(Mechanism mechanism, std::size_t parameter) {
  for (MechanismResponse& response : mechanism.responses) {
    if (response.sees_law) response.uses = united({response.uses, ParameterSet{parameter}});
  }
  return mechanism;
}

}  // namespace camlaw::problems
