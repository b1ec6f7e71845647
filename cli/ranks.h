// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cli/command.h"
#include "optim/crew/mpi_ranks.h"
#include "optim/study/workers.h"

/// Studies whose searches the ranks of MPI carry out (docs/scale.md).
namespace camlaw::cli {

/// --executor {processes,mpi}.
Option executor_option(std::optional<std::string>& executor);

/// The ranks that mpirun has started, where --executor is mpi; null: the searches are of processes
/// of this machine. Throws std::invalid_argument for other words, and where --workers is given too.
std::unique_ptr<optim::MpiRanks> ranks_of(const std::optional<std::string>& executor,
                                          const std::optional<std::string>& workers);

/// Whether this process is a rank that searches for another one; then it has done so.
bool has_served(optim::MpiRanks* ranks);

/// Searches by ranks, about `problem` as worker_program has it.
class RankExecutor final : public optim::Executor {
 public:
  /// All but the text are referred to.
  RankExecutor(const std::string& problem, const optim::OptimiseOptions& options,
               optim::MpiRanks& ranks);
  std::vector<optim::Outcome> run(const std::vector<optim::Task>& tasks,
                                  const optim::OnOutcome& on_outcome) override {
    return tasks_.run(tasks, on_outcome);
  }
  std::string remark() const override { return tasks_.remark(); }

 private:
  optim::ParcelForce force_;
  optim::WorkforceExecutor tasks_;
};

}  // namespace camlaw::cli
