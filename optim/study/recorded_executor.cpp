// SPDX-License-Identifier: MIT
#include "optim/study/recorded_executor.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <utility>

#include "optim/pareto/judged_again.h"

namespace camlaw::optim {

std::string_view to_string(RecordFault::Kind kind) {
  switch (kind) {
    case RecordFault::Kind::Damaged:
      return "damaged";
    case RecordFault::Kind::Wrong:
      return "wrong";
    case RecordFault::Kind::Lost:
      break;
  }
  return "lost";
}

RecordedExecutor::RecordedExecutor(const ProblemSpace& space, StudyRecord& record, Executor* others)
    : space_(&space), record_(record), others_(others) {
  forget_damaged();
}

RecordedExecutor::RecordedExecutor(ProblemOf problem, StudyRecord& record, Executor* others)
    : problem_of_(std::move(problem)), record_(record), others_(others) {
  forget_damaged();
}

void RecordedExecutor::forget_damaged() {
  std::vector<std::int64_t> gone = record_.damaged();
  for (const std::int64_t task : gone) faults_[task] = {task};
  lost_ = record_.lost();
  if (others_ == nullptr) return;
  gone.insert(gone.end(), lost_.begin(), lost_.end());  // what is left of them
  record_.forget(gone);
}

/// Once a task is not there: what a study does not come to need it does not lack.
void RecordedExecutor::name_lost() {
  for (const std::int64_t task : lost_) {
    faults_.try_emplace(task, RecordFault{task, RecordFault::Kind::Lost});
  }
}

const Problem& RecordedExecutor::problem(std::size_t part, const Outcome& outcome) {
  if (space_ == nullptr) {
    last_ = outcome.points.empty() ? Problem{} : problem_of_(part, outcome.points.front().x);
    return last_;
  }
  const auto known = problems_.find(part);
  if (known != problems_.end()) return known->second;
  return problems_.emplace(part, space_->problem(space_->options(part))).first->second;
}

std::string RecordedExecutor::why_wrong(const Outcome& outcome, std::size_t part) {
  for (const FrontPoint& point : outcome.points) {
    const std::vector<std::string> all = differences(problem(part, outcome), point);
    if (!all.empty()) return fmt::format("{}", fmt::join(all, "; "));
  }
  return {};
}

/// What a scout found is where to look, not an answer: it is taken as it is.
std::optional<Outcome> RecordedExecutor::find(const Task& task) {
  std::optional<Outcome> outcome =
      space_ == nullptr ? record_.find(task) : record_.find(task, problem(task.part, {}));
  if (!outcome) {
    for (const std::int64_t number : record_.damaged()) {
      faults_.try_emplace(number, RecordFault{number});
    }
    return {};
  }
  // A process that died may have been killed: it is not the task's outcome for good.
  if (outcome->died && others_ != nullptr) return {};
  if (task.looks_at_many()) return outcome;
  const std::string why = why_wrong(*outcome, task.part);
  if (why.empty()) return outcome;
  const std::int64_t number = record_.number(task).value_or(0);
  faults_[number] = {number, RecordFault::Kind::Wrong, why};
  if (others_ != nullptr) record_.forget({number});
  return {};
}

Outcomes RecordedExecutor::run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) {
  Outcomes outcomes;
  std::vector<Task> missing;
  for (const Task& task : tasks) {
    outcomes.push_back(find(task));
    if (!outcomes.back()) {
      missing.push_back(task);
    } else if (on_outcome) {
      on_outcome(task, *outcomes.back());
    }
  }
  if (!missing.empty()) name_lost();
  if (others_ == nullptr || missing.empty()) return outcomes;
  Outcomes fresh = others_->run(missing, [&](const Task& task, const Outcome& outcome) {
    record_.add(task, outcome, problem(task.part, outcome));
    if (on_outcome) on_outcome(task, outcome);
  });
  auto next = fresh.begin();
  for (auto& outcome : outcomes) {
    if (!outcome) outcome = std::move(*next++);
  }
  return outcomes;
}

std::vector<RecordFault> RecordedExecutor::faults() const {
  std::vector<RecordFault> result;
  for (const auto& [number, fault] : faults_) result.push_back(fault);
  return result;
}

std::vector<Outcome> RecordedExecutor::believed() {
  std::vector<Outcome> result;
  const std::size_t parts = space_ == nullptr ? SIZE_MAX : space_->parts();
  for (RecordedTask& task : record_.whole()) {
    if (looks_at_many(task.text) || faults_.contains(task.number)) continue;
    const std::string why = task.part < parts ? why_wrong(task.outcome, task.part)
                                              : "there is no such combination of choices";
    if (why.empty()) {
      result.push_back(std::move(task.outcome));
    } else {
      faults_[task.number] = {task.number, RecordFault::Kind::Wrong, why};
    }
  }
  return result;
}

}  // namespace camlaw::optim
