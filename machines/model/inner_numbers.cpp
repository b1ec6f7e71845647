// SPDX-License-Identifier: MIT
#include "machines/model/inner_numbers.h"

#include <algorithm>

#include "machines/model/law_binding.h"
#include "optim/cycle/peak_function.h"

namespace camlaw::problems {

InnerNumber inner_peak(const MechanismResponse& curve, optim::Part part) {
  return {part_name(part, curve.name), curve.unit, curve.uses,
          [name = curve.name, unit = curve.unit, make = curve.curve, part](const Binding& binding) {
            const optim::Response whole{name, unit, make(binding, optim::Shape::General)};
            return optim::peak_function(whole, part, design_size(binding));
          }};
}

InnerNumber inner_number(const MechanismResponse& response) {
  return {response.name, response.unit, response.uses,
          [make = response.number](const Binding& binding) {
            return make(binding, optim::Shape::General);
          }};
}

std::size_t design_size(const Binding& binding) {
  std::size_t size = 0;
  for (const std::size_t variable : binding.variables) size = std::max(size, variable + 1);
  for (const LawVariable& v : binding.law->variables()) size = std::max(size, v.variable + 1);
  return size;
}

}  // namespace camlaw::problems
