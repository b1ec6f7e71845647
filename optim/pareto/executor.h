// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/task.h"

namespace camlaw::optim {

/// Called with each outcome as soon as it is there, in any order.
using OnOutcome = std::function<void(const Task&, const Outcome&)>;

/// Carries tasks out: here, in other processes, or from a record of what was done before.
class Executor {
 public:
  virtual ~Executor() = default;
  /// The outcomes in the order of the tasks; of as many as were done, from the first on: fewer only
  /// where the study is to stop.
  virtual std::vector<Outcome> run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) = 0;
  /// What a user should know of how tasks were carried out, such as that they were not carried out
  /// side by side; empty: nothing. The outcomes are the same.
  virtual std::string remark() const { return {}; }
};

/// One after the other, in this process.
class DirectExecutor final : public Executor {
 public:
  DirectExecutor(const MultiSpace& space, const OptimiseOptions& options)
      : space_(space), options_(options) {}
  std::vector<Outcome> run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;

 private:
  const MultiSpace& space_;
  const OptimiseOptions& options_;
};

/// A task carried out; what is thrown on the way becomes the outcome's failure. Numbers are as a
/// record keeps them: zero has no sign, and there is one NaN.
Outcome carry_out_safely(const Task& task, const MultiSpace& space, const OptimiseOptions& options);

}  // namespace camlaw::optim
