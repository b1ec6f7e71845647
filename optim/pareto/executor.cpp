// SPDX-License-Identifier: MIT
#include "optim/pareto/executor.h"

#include <exception>

namespace camlaw::optim {

Outcome carry_out_safely(const Task& task, const MultiSpace& space,
                         const OptimiseOptions& options) {
  Outcome failed;
  try {
    return carry_out(task, space, options);
  } catch (const std::exception& error) {
    failed.failure = error.what();
  } catch (...) {
    failed.failure = "the model threw something that is no std::exception";
  }
  return failed;
}

std::vector<Outcome> DirectExecutor::run(const std::vector<Task>& tasks, std::size_t) {
  std::vector<Outcome> outcomes;
  for (const Task& task : tasks) {
    if (options_.stop != nullptr && *options_.stop) break;
    Outcome outcome = carry_out_safely(task, space_, options_);
    if (options_.stop != nullptr && *options_.stop) break;  // cut short: not what the task gives
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace camlaw::optim
