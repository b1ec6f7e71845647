// SPDX-License-Identifier: MIT
#include "optim/study/workers.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "optim/search/options_bytes.h"
#include "optim/study/efforts.h"
#include "optim/study/encoding.h"
#include "optim/study/parcel_executor.h"

namespace camlaw::optim {
namespace {

/// The tasks of one run and what has come of them.
class Tasks final : public Errands {
 public:
  Tasks(const std::vector<Task>& tasks, const OptimiseOptions& options, const OnOutcome& on_outcome,
        Efforts& efforts)
      : tasks_(tasks),
        options_(options),
        on_outcome_(on_outcome),
        efforts_(efforts),
        order_(efforts.longest_first(tasks)),
        outcomes_(tasks.size()) {}

  std::optional<std::size_t> next() override {
    if (next_ == order_.size()) return {};
    return order_[next_++];
  }
  std::optional<std::string> order(std::size_t number) override {
    return encoded({tasks_[number], options_});
  }
  void answered(std::size_t number, const std::string& answer) override {
    auto outcome = decoded(answer);
    if (outcome) return end(number, std::move(*outcome));
    lost(number, "the process of this search answered with something that is not an outcome");
  }
  void lost(std::size_t number, const std::string& why) override {
    Outcome failed;
    failed.failure = why;
    failed.died = true;
    end(number, std::move(failed));
  }

  const std::atomic<bool>* stop() const override { return options_.stop; }
  std::string confined() const override { return why_confined(options_); }

  Outcomes take_outcomes() { return std::move(outcomes_); }

 private:
  void end(std::size_t number, Outcome outcome) {
    efforts_.learn(tasks_[number], outcome);
    if (on_outcome_) on_outcome_(tasks_[number], outcome);
    outcomes_[number] = std::move(outcome);
  }

  const std::vector<Task>& tasks_;
  const OptimiseOptions& options_;
  const OnOutcome& on_outcome_;
  Efforts& efforts_;
  std::vector<std::size_t> order_;  ///< in which they are handed out
  std::size_t next_ = 0;
  Outcomes outcomes_;
};

}  // namespace

Service task_service(CarryOut carry_out) {
  return [carry_out = std::move(carry_out)](const std::string& bytes,
                                            const Bench& bench) -> std::optional<std::string> {
    auto order = decoded_order(bytes);
    if (!order) return "";
    order->options.stop = bench.stop;
    return encoded(carry_out(order->task, order->options));
  };
}

Service study_service(ProblemSpace space) {
  return task_service([space = std::move(space)](const Task& task, const OptimiseOptions& options) {
    return carry_out_safely(task, space, options);
  });
}

Outcomes ParcelExecutor::run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) {
  Tasks errands(tasks, options_, on_outcome, efforts_);
  force_.run(errands);
  return errands.take_outcomes();
}

ProcessExecutor::ProcessExecutor(const ProblemSpace& space, const OptimiseOptions& options,
                                 int workers, std::optional<WorkerProgram> program)
    : ProcessExecutor(study_service(space), options, workers, std::move(program)) {}

ProcessExecutor::ProcessExecutor(Service service, const OptimiseOptions& options, int workers,
                                 std::optional<WorkerProgram> program)
    : service_(std::move(service)),
      options_(options),
      crew_({.workers = workers, .program = std::move(program), .at_once = true}),
      efforts_(std::make_unique<Efforts>()) {}

ProcessExecutor::~ProcessExecutor() = default;

Outcomes ProcessExecutor::run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) {
  Tasks errands(tasks, options_, on_outcome, *efforts_);
  crew_.run(errands, service_);
  return errands.take_outcomes();
}

}  // namespace camlaw::optim
