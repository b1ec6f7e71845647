// SPDX-License-Identifier: MIT
#include "optim/pareto/executor.h"

#include <cmath>
#include <exception>
#include <limits>

namespace camlaw::optim {
namespace {

void make_plain(double& value) {
  value = std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value + 0.0;
}

void make_plain(std::vector<double>& values) {
  for (double& value : values) make_plain(value);
}

Outcome plain(Outcome outcome) {
  for (FrontPoint& point : outcome.points) {
    for (auto* values : {&point.x, &point.objectives, &point.costs, &point.weights}) {
      make_plain(*values);
    }
    for (Standing& limit : point.limits) {
      make_plain(limit.margin);
      make_plain(limit.price);
      if (limit.angle) make_plain(*limit.angle);
    }
  }
  return outcome;
}

}  // namespace

Outcome carry_out_safely(const Task& task, const MultiSpace& space,
                         const OptimiseOptions& options) {
  Outcome failed;
  try {
    return plain(carry_out(task, space, options));
  } catch (const std::exception& error) {
    failed.failure = error.what();
  } catch (...) {
    failed.failure = "the model threw something that is not a std::exception";
  }
  return failed;
}

std::vector<Outcome> DirectExecutor::run(const std::vector<Task>& tasks,
                                         const OnOutcome& on_outcome) {
  const auto stopped = [&] { return options_.stop != nullptr && *options_.stop; };
  std::vector<Outcome> outcomes;
  for (const Task& task : tasks) {
    if (stopped()) break;
    Outcome outcome = carry_out_safely(task, space_, options_);
    if (stopped()) break;  // cut short: not what the task gives
    if (on_outcome) on_outcome(task, outcome);
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace camlaw::optim
