// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// A system that can be reproduced by name.
struct ReproducibleSystem {
  std::string name;
  /// Throws optim::Interrupted where `stop`, which may be null, is set before the end; systems that
  /// take some tenths of a second do not look at it.
  std::function<SystemReproduction(const std::atomic<bool>* stop)> reproduce;
};
const std::vector<ReproducibleSystem>& reproducible_systems();

/// Values whose verdict is worse than the one in problems/baseline.csv, each with both; also where
/// a value of the baseline is gone. None as long as nothing that used to reproduce has ceased to.
std::vector<std::string> worsened(const SystemReproduction& result);

}  // namespace camlaw::problems
