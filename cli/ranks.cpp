// SPDX-License-Identifier: MIT
#include "cli/ranks.h"

#include <fmt/format.h>

#include <stdexcept>

#include "fitting/motions/law_fit_service.h"

namespace camlaw::cli {

Option executor_option(std::optional<std::string>& executor) {
  return {"--executor", &executor, "{processes,mpi}",
          "who searches: processes of this machine, or the ranks that mpirun has started"};
}

std::unique_ptr<optim::MpiRanks> ranks_of(const std::optional<std::string>& executor,
                                          const std::optional<std::string>& workers) {
  if (!executor || *executor == "processes") return nullptr;
  if (*executor != "mpi") {
    throw std::invalid_argument(
        fmt::format("--executor: '{}' is neither processes nor mpi", *executor));
  }
  if (workers) {
    throw std::invalid_argument("--workers: with --executor mpi, mpirun says how many there are");
  }
  return std::make_unique<optim::MpiRanks>();
}

bool has_served(optim::MpiRanks* ranks) {
  if (ranks == nullptr || ranks->rank() == 0) return false;
  ranks->serve(problems::service_of_worker_or_fits);
  return true;
}

RankExecutor::RankExecutor(const std::string& problem, const optim::OptimiseOptions& options,
                           optim::MpiRanks& ranks)
    : force_(ranks), tasks_(options, force_) {
  ranks.give(problem);
}

}  // namespace camlaw::cli
