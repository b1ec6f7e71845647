// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// A system that can be reproduced by name.
struct ReproducibleSystem {
  std::string name;
  SystemReproduction (*reproduce)();
};
const std::vector<ReproducibleSystem>& reproducible_systems();

/// Values whose verdict is worse than the one in problems/baseline.csv, each with both; also where
/// a value of the baseline is gone. None as long as nothing that used to reproduce has ceased to.
std::vector<std::string> worsened(const SystemReproduction& result);

}  // namespace camlaw::problems
