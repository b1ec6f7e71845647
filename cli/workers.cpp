// SPDX-License-Identifier: MIT
#include "cli/workers.h"

#include <algorithm>
#include <cmath>

#include "optim/crew/crew.h"
#include "optim/search/memory.h"
#include "problems/statement/solver_settings.h"

namespace camlaw::cli {

Option workers_option(std::optional<std::string>& workers) {
  return {"--workers", &workers, takes::kNumber,
          "number of worker processes; the answer does not depend on it"};
}

int workers_of(const std::optional<std::string>& workers) {
  if (!workers) return optim::usual_workers();
  return static_cast<int>(problems::parse_integer(*workers, 1, optim::kMostWorkers, "--workers"));
}

int workers_with_room(int workers, const optim::Problem& problem, double allowed) {
  const optim::MemoryNeed need = optim::check_memory(problem, allowed);
  const double room = std::floor(allowed / std::max(need.bytes, 1.0));
  return static_cast<int>(std::min<double>(workers, room));
}

}  // namespace camlaw::cli
