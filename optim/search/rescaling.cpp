// SPDX-License-Identifier: MIT
#include "optim/search/rescaling.h"

namespace camlaw::optim {

bool differ(const Scales& a, const Scales& b) {
  constexpr double kFactor = 10;  // tolerances of rows then miss what they mean by as much (SC4)
  const auto far = [](double p, double q) { return p > kFactor * q || q > kFactor * p; };
  if (far(a.objective, b.objective)) return true;
  for (std::size_t i = 0; i < a.variables.size(); ++i) {
    if (far(a.variables[i], b.variables[i])) return true;
  }
  for (std::size_t i = 0; i < a.constraints.size(); ++i) {
    if (far(a.constraints[i].scale, b.constraints[i].scale)) return true;
    if (far(a.constraints[i].tolerance, b.constraints[i].tolerance)) return true;
  }
  return false;
}

}  // namespace camlaw::optim
