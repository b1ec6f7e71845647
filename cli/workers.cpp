// SPDX-License-Identifier: MIT
#include "cli/workers.h"

#include "optim/crew/crew.h"
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

}  // namespace camlaw::cli
