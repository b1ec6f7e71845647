// SPDX-License-Identifier: MIT
#include "optim/verdict/variation.h"

#include <cmath>

#include "numerics/sampling/sobol_points.h"

namespace camlaw::optim {

double Variation::deviation() const { return half() / (is_normal ? 3 : std::sqrt(3.0)); }

double Variation::at(double u) const {
  if (is_normal) return middle() + deviation() * u;
  return middle() + half() * std::erf(u / std::sqrt(2.0));
}

double Variation::slope(double u) const {
  return is_normal ? deviation() : 2 * half() * normal_density(u);
}

double Variation::at_share(double share) const {
  if (is_normal) return middle() + deviation() * normal_quantile(share);
  return lower + (upper - lower) * share;
}

}  // namespace camlaw::optim
