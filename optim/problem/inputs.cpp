// SPDX-License-Identifier: MIT
#include "optim/problem/inputs.h"

#include <cmath>

namespace camlaw::optim {

std::set<std::size_t> inputs_of(const Response& response, const Problem& problem) {
  if (!response.is_curve()) {
    const auto& inputs = response.function().inputs();
    return {inputs.begin(), inputs.end()};
  }
  std::set<std::size_t> all;
  const std::vector<double> breaks = response.curve().trace(problem.start())->breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (const double share : {0.0, 0.13, 0.5, 0.87}) {
      const Function there = response.curve().at({std::lerp(breaks[k], breaks[k + 1], share)});
      all.insert(there.inputs().begin(), there.inputs().end());
    }
  }
  return all;
}

}  // namespace camlaw::optim
