// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// Of a response that is linear in each of these sets of parameters, where the others rest.
inline std::vector<ShapeStatement> linear(std::vector<std::vector<std::string>> alone) {
  std::vector<ShapeStatement> shapes;
  for (auto& varying : alone) shapes.push_back({std::move(varying), optim::Shape::Linear});
  return shapes;
}

}  // namespace camlaw::problems
