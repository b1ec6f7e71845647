// SPDX-License-Identifier: MIT
#include "problems/fits/coefficients.h"

#include "problems/statement/parameters.h"

namespace camlaw::problems {

std::vector<Coefficient> coefficients_of(const Member& law, std::size_t first) {
  std::vector<Coefficient> result;
  const auto& parameters = law.family->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    if (p.structural || p.name == kCrossover) continue;
    const auto& values = law.arguments.list(i);
    for (std::size_t k = 0; k < values.size(); ++k) {
      result.push_back({{i, k, first + result.size()},
                        named(p).element_name(k),
                        p.unit,
                        p.low,
                        p.high,
                        values[k]});
    }
  }
  return result;
}

}  // namespace camlaw::problems
