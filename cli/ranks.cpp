// SPDX-License-Identifier: MIT
#include "cli/ranks.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "fitting/motions/law_fit_service.h"
#include "optim/study/parcel_executor.h"
#include "optim/study/workers.h"

namespace camlaw::cli {

Option executor_option(std::optional<std::string>& executor) {
  return {"--executor", &executor, "{processes,mpi}",
          "what does the work: processes of this machine, or the ranks that mpirun has started"};
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
  if (ranks != nullptr) {
    ranks->give(program.problem);
    const auto force = std::make_shared<optim::ParcelForce>(*ranks);
    return [force](optim::Errands& errands, const optim::Service&) { force->run(errands); };
  }
  const auto crew =
      std::make_shared<optim::Crew>(optim::CrewRules{.workers = count, .program = program});
  return [crew](optim::Errands& errands, const optim::Service& service) {
    crew->run(errands, service);
  };
}

}  // namespace camlaw::cli
