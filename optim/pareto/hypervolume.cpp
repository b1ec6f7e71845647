// SPDX-License-Identifier: MIT
#include <algorithm>
#include <pagmo/utils/hypervolume.hpp>

#include "optim/pareto/measures.h"

namespace camlaw::optim {

double hypervolume(std::span<const Costs> front, const Costs& reference) {
  std::vector<Costs> inside;
  for (const Costs& point : front) {
    const bool below = std::equal(point.begin(), point.end(), reference.begin(),
                                  [](double cost, double bound) { return cost < bound; });
    if (below) inside.push_back(point);
  }
  return inside.empty() ? 0 : pagmo::hypervolume(inside, false).compute(reference);
}

}  // namespace camlaw::optim
