// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/task.h"

namespace camlaw::optim {

/// Carries tasks out: here, in other processes, or from a record of what was done before.
class Executor {
 public:
  virtual ~Executor() = default;
  /// The outcomes in the order of the tasks, of as many as were done: fewer only when the study is
  /// to stop. `first` is the number of the first task, counted over the whole study.
  virtual std::vector<Outcome> run(const std::vector<Task>& tasks, std::size_t first) = 0;
};

/// One after the other, in this process. What a model throws is a failed outcome.
class DirectExecutor final : public Executor {
 public:
  DirectExecutor(const MultiSpace& space, const OptimiseOptions& options)
      : space_(space), options_(options) {}
  std::vector<Outcome> run(const std::vector<Task>& tasks, std::size_t first) override;

 private:
  const MultiSpace& space_;
  const OptimiseOptions& options_;
};

/// A task carried out; what is thrown on the way becomes the outcome's failure.
Outcome carry_out_safely(const Task& task, const MultiSpace& space, const OptimiseOptions& options);

}  // namespace camlaw::optim
