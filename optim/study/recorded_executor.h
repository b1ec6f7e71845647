// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "optim/pareto/task.h"
#include "optim/study/record.h"

namespace camlaw::optim {

/// A task of a record that is not believed.
struct RecordFault {
  enum class Kind {
    Damaged,  ///< its rows were changed after they were written
    Wrong,    ///< what they say is
    Lost,     ///< its row is missing
  };
  std::int64_t task = 0;  ///< the number of its row
  Kind kind = Kind::Damaged;
  std::string why = {};  ///< of what is wrong, with what is stated and what is found
};
/// "damaged", "wrong" or "lost".
std::string_view to_string(RecordFault::Kind kind);

/// What a record has is taken from it; the rest another executor carries out, and the record takes
/// it down. Nothing in the record is believed that does not hold when its designs are evaluated
/// again (differences()): such a task, like one whose rows are damaged, counts as not there, and is
/// named, and so is one whose row is gone, where the study comes to lack a task. Without another
/// executor the study stops at the first task that is not there.
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
  void name_lost();
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
  std::vector<std::int64_t> lost_;  ///< when the record was opened
};

}  // namespace camlaw::optim
