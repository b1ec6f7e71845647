// SPDX-License-Identifier: MIT
#include "optim/problem/combinations.h"

#include <fmt/format.h>

#include <stdexcept>

namespace camlaw::optim {

std::size_t combinations_of(const std::vector<Choice>& choices) {
  std::size_t product = 1;
  for (const Choice& choice : choices) {
    if (choice.options.empty()) {
      throw std::invalid_argument(fmt::format("choice '{}': it has no options", choice.name));
    }
    product *= choice.options.size();
    if (product > kMostCombinations) {
      throw std::invalid_argument(
          fmt::format("choice '{}': more than {} combinations", choice.name, kMostCombinations));
    }
  }
  return product;
}

}  // namespace camlaw::optim
