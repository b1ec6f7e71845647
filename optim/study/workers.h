// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "optim/pareto/task.h"

/// Searches of a front in processes side by side.
namespace camlaw::optim {

class WorkerProcess;

/// How long a program that was started may take to say that it is a worker. It says so before it
/// does anything else, within some milliseconds: what takes longer is another program.
inline constexpr std::chrono::milliseconds kGreetingPatience{5000};

/// How a program is started that works on a study.
struct WorkerProgram {
  std::string path;     ///< of the program, which calls serve_as_program on its standard input
  std::string problem;  ///< the study's problem, as the program takes it
  std::chrono::milliseconds patience = kGreetingPatience;
};

/// Carries tasks out in processes of their own, `workers` at a time. A process that dies takes its
/// task with it and nothing else: the outcome is a failure that says how it died. The outcomes are
/// those of DirectExecutor to the last bit.
///
/// Where this process has one thread, workers are copies of it (fork). Where it has several they
/// are started afresh from `program`; without one, or where it cannot be started, tasks are carried
/// out here, one after the other, and remark() says so. An executor is one thread's at a time;
/// several threads may have one each.
class ProcessExecutor final : public Executor {
 public:
  /// Throws std::invalid_argument for no workers at all.
  ProcessExecutor(const ProblemSpace& space, const OptimiseOptions& options, int workers,
                  std::optional<WorkerProgram> program = {});
  ProcessExecutor(ProcessExecutor&&) noexcept;
  ~ProcessExecutor() override;

  std::vector<Outcome> run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;
  std::string remark() const override { return remark_; }

 private:
  class Run;
  /// One that waits for a task; null where none can be had, and remark_ says why.
  WorkerProcess* hire();
  void stay_here(const std::string& why);

  const ProblemSpace& space_;
  const OptimiseOptions& options_;
  std::size_t workers_;
  std::optional<WorkerProgram> program_;
  std::string remark_;
  std::vector<WorkerProcess> crew_;  ///< those started afresh stay from run to run
};

}  // namespace camlaw::optim
