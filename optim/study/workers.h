// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/pareto/task.h"

/// Searches of a front in processes side by side.
namespace camlaw::optim {

class Efforts;

/// Carries tasks out in processes of their own, `workers` at a time (optim/crew/crew.h). A process
/// that dies takes its task with it and nothing else: the outcome is a failure that says how it
/// died. The outcomes are those of DirectExecutor to the last bit. An executor is one thread's at a
/// time; several threads may have one each.
class ProcessExecutor final : public Executor {
 public:
  /// Throws std::invalid_argument for no workers at all.
  ProcessExecutor(const ProblemSpace& space, const OptimiseOptions& options, int workers,
                  std::optional<WorkerProgram> program = {});
  /// The same of tasks that `service` carries out (task_service).
  ProcessExecutor(Service service, const OptimiseOptions& options, int workers,
                  std::optional<WorkerProgram> program = {});

  Outcomes run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;
  std::string remark() const override { return crew_.remark(); }
  ~ProcessExecutor() override;

 private:
  Service service_;
  const OptimiseOptions& options_;
  Crew crew_;
  std::unique_ptr<Efforts> efforts_;
};

/// What becomes of a task.
using CarryOut = std::function<Outcome(const Task&, const OptimiseOptions&)>;

/// What a worker does for a study: orders are tasks (encoding.h).
Service task_service(CarryOut carry_out);
/// The same of the tasks of a space, which it holds.
Service study_service(ProblemSpace space);

}  // namespace camlaw::optim
