// SPDX-License-Identifier: MIT
#include "cli/ranks.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "fitting/motions/law_fit_service.h"
#include "optim/crew/hands.h"
#include "optim/study/parcel_executor.h"
#include "optim/study/workers.h"

namespace camlaw::cli {

Option executor_option(std::optional<std::string>& executor) {
  return {"--executor", &executor, "{processes,mpi}",
          "where the work is done: in processes of this machine, or in the ranks that mpirun has "
          "started"};
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

std::unique_ptr<optim::Executor> executor_of(optim::Service service,
                                             const optim::WorkerProgram& program,
                                             const optim::OptimiseOptions& options, int count,
                                             optim::MpiRanks* ranks) {
  if (ranks == nullptr) {
    return std::make_unique<optim::ProcessExecutor>(std::move(service), options, count, program);
  }
  ranks->give(program.problem);
  return std::make_unique<optim::ParcelExecutor>(options, *ranks);
}

optim::Hands hands_of(const optim::WorkerProgram& program, int count, optim::MpiRanks* ranks) {
  if (ranks == nullptr) return optim::hands_of_crew({.workers = count, .program = program});
  ranks->give(program.problem);
  // The ranks stay with whoever began them.
  return optim::hands_beyond({std::shared_ptr<void>(), ranks});
}

}  // namespace camlaw::cli
