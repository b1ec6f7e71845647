// SPDX-License-Identifier: MIT
#pragma once

#include "optim/crew/parcels.h"
#include "optim/pareto/task.h"
#include "optim/study/efforts.h"

namespace camlaw::optim {

/// Sends tasks to workers elsewhere, which know by themselves how one is carried out (parcels.h).
/// The outcomes are those of DirectExecutor to the last bit.
class ParcelExecutor final : public Executor {
 public:
  /// Both are referred to.
  ParcelExecutor(const OptimiseOptions& options, Transport& transport)
      : options_(options), force_(transport) {}

  Outcomes run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;

 private:
  const OptimiseOptions& options_;
  ParcelForce force_;
  Efforts efforts_;
};

}  // namespace camlaw::optim
