// SPDX-License-Identifier: MIT
#include "optim/study/workers.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <utility>

#include "optim/solvers/solver.h"
#include "optim/study/child_process.h"
#include "optim/study/worker_process.h"

namespace camlaw::optim {
namespace {

/// A solver that a search asks for and that this process alone knows; empty where there is none.
std::string registered_solver(const OptimiseOptions& options) {
  if (is_registered(options.solver)) return options.solver;
  for (const auto& [solver, native] : options.native) {
    if (is_registered(solver)) return solver;
  }
  return "";
}

}  // namespace

/// The tasks of one run: which wait, which are done.
class ProcessExecutor::Run {
 public:
  Run(ProcessExecutor& executor, const std::vector<Task>& tasks, const OnOutcome& on_outcome)
      : executor_(executor), tasks_(tasks), on_outcome_(on_outcome), outcomes_(tasks.size()) {
    for (std::size_t i = 0; i < tasks.size(); ++i) waiting_.push_back(i);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  /// Workers that are in the middle of a task end with it, and copies of this process, which the
  /// next run may find changed.
  ~Run() {
    std::erase_if(executor_.crew_,
                  [](const WorkerProcess& w) { return w.is_busy() || w.is_forked(); });
  }

  void carry_out() {
    while (done_ < tasks_.size() && !stopped()) {
      hand_out();
      if (done_ < tasks_.size() && !stopped()) listen();
    }
  }

  std::vector<Outcome> in_order() {
    std::vector<Outcome> result;
    for (auto& outcome : outcomes_) {
      if (!outcome) break;
      result.push_back(std::move(*outcome));
    }
    return result;
  }

 private:
  bool stopped() const { return executor_.options_.stop != nullptr && *executor_.options_.stop; }

  /// Gives waiting tasks to workers; where there are none to be had, one is done here.
  void hand_out() {
    while (!waiting_.empty()) {
      const std::size_t number = waiting_.front();
      const std::size_t busy = count_of_busy();
      if (busy >= executor_.workers_) return;
      WorkerProcess* worker = executor_.hire();
      if (worker != nullptr) {
        if (worker->give(number, tasks_[number], executor_.options_)) waiting_.pop_front();
        continue;
      }
      if (busy > 0) return;
      waiting_.pop_front();
      Outcome outcome = carry_out_safely(tasks_[number], executor_.space_, executor_.options_);
      if (stopped()) return;  // cut short: not what the task gives
      end(number, std::move(outcome));
    }
  }

  std::size_t count_of_busy() const {
    return static_cast<std::size_t>(
        std::count_if(executor_.crew_.begin(), executor_.crew_.end(),
                      [](const WorkerProcess& worker) { return worker.is_busy(); }));
  }

  /// Waits a little for what workers have to say.
  void listen() {
    constexpr int kMilliseconds = 100;  // after which an interrupt is looked for
    std::vector<pollfd> files;
    for (const WorkerProcess& worker : executor_.crew_) {
      // Of one that is not busy nothing is to be heard, not even that it has ended.
      files.push_back({worker.is_busy() ? worker.socket() : -1, POLLIN, 0});
    }
    if (poll(files.data(), files.size(), kMilliseconds) < 0) return;
    std::vector<std::pair<std::size_t, Outcome>> ended;
    for (std::size_t i = 0; i < files.size(); ++i) {
      WorkerProcess& worker = executor_.crew_[i];
      if (!worker.is_busy()) continue;
      const std::size_t number = worker.task();
      WorkerProcess::News news = files[i].revents != 0 ? worker.read() : worker.late();
      if (!news.failed_to_start.empty()) {
        executor_.stay_here(news.failed_to_start);
        waiting_.insert(std::lower_bound(waiting_.begin(), waiting_.end(), number), number);
      } else if (news.outcome) {
        ended.emplace_back(number, std::move(*news.outcome));
      }
    }
    std::erase_if(executor_.crew_, [](const WorkerProcess& worker) { return worker.has_ended(); });
    for (auto& [number, outcome] : ended) end(number, std::move(outcome));
  }

  void end(std::size_t number, Outcome outcome) {
    if (on_outcome_) on_outcome_(tasks_[number], outcome);
    outcomes_[number] = std::move(outcome);
    ++done_;
  }

  ProcessExecutor& executor_;
  const std::vector<Task>& tasks_;
  const OnOutcome& on_outcome_;
  std::deque<std::size_t> waiting_;  ///< in order
  std::vector<std::optional<Outcome>> outcomes_;
  std::size_t done_ = 0;
};

ProcessExecutor::ProcessExecutor(const ProblemSpace& space, const OptimiseOptions& options,
                                 int workers, std::optional<WorkerProgram> program)
    : space_(space), options_(options), workers_(0), program_(std::move(program)) {
  if (workers < 1) throw std::invalid_argument("workers: at least one is needed");
  workers_ = static_cast<std::size_t>(workers);
}

ProcessExecutor::ProcessExecutor(ProcessExecutor&&) noexcept = default;
ProcessExecutor::~ProcessExecutor() = default;

void ProcessExecutor::stay_here(const std::string& why) {
  program_.reset();
  remark_ = fmt::format("searched in the calling process, one search at a time: {}", why);
}

WorkerProcess* ProcessExecutor::hire() {
  std::erase_if(crew_, [](const WorkerProcess& w) { return !w.is_busy() && !w.is_idle(); });
  for (WorkerProcess& worker : crew_) {
    if (worker.is_idle()) return &worker;
  }
  if (has_one_thread()) return &crew_.emplace_back(WorkerProcess::forked(space_, crew_));
  if (!program_) {
    if (remark_.empty()) stay_here("it has several threads, and the problem is not sent as data");
    return nullptr;
  }
  if (const std::string own = registered_solver(options_); !own.empty()) {
    stay_here(fmt::format("it has several threads, and no other process knows the solver {}", own));
    return nullptr;
  }
  try {
    return &crew_.emplace_back(WorkerProcess::started(*program_));
  } catch (const std::runtime_error& error) {
    stay_here(error.what());
    return nullptr;
  }
}

std::vector<Outcome> ProcessExecutor::run(const std::vector<Task>& tasks,
                                          const OnOutcome& on_outcome) {
  Run run(*this, tasks, on_outcome);
  run.carry_out();
  return run.in_order();
}

}  // namespace camlaw::optim
