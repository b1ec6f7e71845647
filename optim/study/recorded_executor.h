// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/task.h"
#include "optim/study/record.h"

namespace camlaw::optim {

/// A task of a record that is not believed.
struct RecordFault {
  std::int64_t task = 0;   ///< the number of its row
  bool is_damaged = true;  ///< its rows are not as they were written; else what they say is wrong
  std::string why;         ///< of what is wrong, with what is stated and what is found
};

/// What a record has is taken from it; the rest another executor carries out, and the record takes
/// it down. Nothing in the record is believed that does not hold when its designs are evaluated
/// again (differences()): such a task, like one whose rows are damaged, counts as not there, and is
/// named. Without another executor the study stops at the first task that is not there.
class RecordedExecutor final : public Executor {
 public:
  RecordedExecutor(const ProblemSpace& space, StudyRecord& record, Executor* others);
  /// The same of tasks whose problem each design tells: that of a part and a design as they are
  /// recorded.
  using ProblemOf = std::function<Problem(std::size_t part, Design x)>;
  RecordedExecutor(ProblemOf problem, StudyRecord& record, Executor* others);
  Outcomes run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;
  std::string remark() const override { return others_ == nullptr ? "" : others_->remark(); }

  /// What was not believed so far, by number; with another executor it is carried out again.
  std::vector<RecordFault> faults() const;
  /// The outcomes of all searches that are believed, whether the study came to ask for them or not.
  std::vector<Outcome> believed();

 private:
  void forget_damaged();
  /// Of the designs of a task.
  const Problem& problem(std::size_t part, const Outcome& outcome);
  /// Why an outcome is not believed; empty where it is.
  std::string why_wrong(const Outcome& outcome, std::size_t part);
  std::optional<Outcome> find(const Task& task);

  const ProblemSpace* space_ = nullptr;  ///< null: problem_of_ tells
  ProblemOf problem_of_ = {};
  StudyRecord& record_;
  Executor* others_;
  std::map<std::size_t, Problem> problems_;  ///< of each part of the space that was met
  Problem last_ = {};                        ///< that problem_of_ told
  std::map<std::int64_t, RecordFault> faults_;
};

}  // namespace camlaw::optim
