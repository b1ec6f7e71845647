// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cli/command.h"
#include "optim/crew/mpi_ranks.h"
#include "optim/pareto/task.h"

/// Studies whose searches the ranks of MPI carry out (docs/scale.md).
namespace camlaw::cli {

/// --executor {processes,mpi}.
Option executor_option(std::optional<std::string>& executor);

/// The ranks that mpirun has started, where --executor is mpi; null: the searches are of processes
/// of this machine. Throws std::invalid_argument for other words, and where --workers is given too.
std::unique_ptr<optim::MpiRanks> ranks_of(const std::optional<std::string>& executor,
                                          const std::optional<std::string>& workers);

/// Whether this process is a rank that works for another one; then it has done so.
bool has_served(optim::MpiRanks* ranks);

/// Who carries a study's tasks out: the ranks, which are told of the program's problem; where there
/// are none `count` processes, by `service` or as the program. Options and ranks are referred to.
std::unique_ptr<optim::Executor> executor_of(optim::Service service,
                                             const optim::WorkerProgram& program,
                                             const optim::OptimiseOptions& options, int count,
                                             optim::MpiRanks* ranks);

/// Who carries out errands that are no searches of a study: the ranks, or `count` processes where
/// the work is seen to be long.
optim::Hands hands_of(const optim::WorkerProgram& program, int count, optim::MpiRanks* ranks);

}  // namespace camlaw::cli
