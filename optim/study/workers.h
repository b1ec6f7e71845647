// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/executor.h"

namespace camlaw::optim {

/// Carries tasks out in processes of their own, `workers` at a time. A process that dies takes its
/// task with it and nothing else: the outcome is a failure that says how it died. The outcomes are
/// those of DirectExecutor to the last bit. To be used from a process without other threads.
class ProcessExecutor final : public Executor {
 public:
  /// Throws std::invalid_argument for no workers at all.
  ProcessExecutor(const MultiSpace& space, const OptimiseOptions& options, int workers);
  std::vector<Outcome> run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;

 private:
  const MultiSpace& space_;
  const OptimiseOptions& options_;
  int workers_;
};

}  // namespace camlaw::optim
