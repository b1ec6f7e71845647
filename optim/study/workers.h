// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/pareto/task.h"

/// Searches of a front in processes side by side.
namespace camlaw::optim {

/// Hands tasks to a workforce. The outcomes are those of DirectExecutor to the last bit.
class WorkforceExecutor final : public Executor {
 public:
  /// All are referred to.
  WorkforceExecutor(const ProblemSpace& space, const OptimiseOptions& options, Workforce& force)
      : space_(space), options_(options), force_(force) {}

  std::vector<Outcome> run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;
  std::string remark() const override { return force_.remark(); }

 private:
  const ProblemSpace& space_;
  const OptimiseOptions& options_;
  Workforce& force_;
};

/// Carries tasks out in processes of their own, `workers` at a time (optim/crew/crew.h). A process
/// that dies takes its task with it and nothing else: the outcome is a failure that says how it
/// died. The outcomes are those of DirectExecutor to the last bit. An executor is one thread's at a
/// time; several threads may have one each.
class ProcessExecutor final : public Executor {
 public:
  /// Throws std::invalid_argument for no workers at all.
  ProcessExecutor(const ProblemSpace& space, const OptimiseOptions& options, int workers,
                  std::optional<WorkerProgram> program = {});

  std::vector<Outcome> run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;
  std::string remark() const override { return crew_.remark(); }

 private:
  const ProblemSpace& space_;
  const OptimiseOptions& options_;
  Crew crew_;
};

/// What a worker does for a study: orders are tasks (encoding.h). Holds the space.
Service study_service(ProblemSpace space);

}  // namespace camlaw::optim
