// SPDX-License-Identifier: MIT
#include "fitting/motions/coefficients.h"

#include <algorithm>

#include "kinematics/shape.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {

std::vector<Coefficient> coefficients_of(const Member& law, std::size_t first, Skew skew) {
  std::vector<Coefficient> result;
  const auto& parameters = law.family->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    if (p.structural || (p.name == kCrossover && skew == Skew::Held)) continue;
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

bool can_be_skewed(const Member& law) {
  const auto& parameters = law.family->parameters;
  const auto crossover = std::find_if(parameters.begin(), parameters.end(),
                                      [](const Parameter& p) { return p.name == kCrossover; });
  if (crossover == parameters.end()) return false;
  // Enough to be seen beside rounding, and within the range of any coefficient.
  constexpr double kAside = 0.01;
  Member other{law.family, law.family->defaults()};
  if (!is_symmetric(other.law())) return false;
  for (const Coefficient& c : coefficients_of(other)) {
    Member aside = other;
    aside.arguments.values()[c.at.parameter][c.at.element] =
        c.value + kAside * (c.value < c.high / 2 ? 1 : -1);
    const auto skew = aside.possible_law();  // none where these numbers go together
    if (skew && !is_symmetric(*skew)) return false;
  }
  return true;
}

}  // namespace camlaw::problems
