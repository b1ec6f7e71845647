// SPDX-License-Identifier: MIT
#include "problems/statement/added_part.h"

#include <algorithm>

namespace camlaw::problems {

bool is_of_added_part(const Mechanism& mechanism, const BuildableCheck& check) {
  const auto& all = mechanism.parameters;
  const auto is_none_by_default = [&](const std::string& name) {
    return std::any_of(all.begin(), all.end(), [&](const MechanismParameter& p) {
      return p.name == name && p.default_value == 0;
    });
  };
  const auto& needs = check.needs;
  return !needs.empty() && check.one_of.empty() &&
         std::all_of(needs.begin(), needs.end(), is_none_by_default);
}

bool has_part_of(const Mechanism& mechanism, const BuildableCheck& check,
                 const StatedNumber& stated) {
  return !is_of_added_part(mechanism, check) ||
         std::any_of(check.needs.begin(), check.needs.end(),
                     [&](const std::string& name) { return stated(name).has_value(); });
}

}  // namespace camlaw::problems
