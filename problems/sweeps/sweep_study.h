// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "numerics/possible.h"
#include "optim/pareto/task.h"
#include "optim/study/record.h"
#include "problems/statement/bind.h"
#include "problems/sweeps/plan.h"

/// A problem file with each combination of some settings: one optimum, or one evaluation, for each.
/// Every search is a task of a study (optim/study), so that what holds for fronts holds here: the
/// outcome of a task follows from the task and the problem alone.
namespace camlaw::problems {

struct SweepProgress {
  std::size_t done = 0, all = 0;    ///< combinations
  std::optional<double> best = {};  ///< of the first objective
};

/// What came of each combination.
struct SweptCombinations {
  std::vector<std::optional<optim::Outcome>> outcomes;  ///< none: it was not come to
  /// Whether the search began at the design of a neighbour.
  std::vector<bool> is_warm;
  std::string remark = {};  ///< Executor::remark

  std::size_t done() const;
};

/// A variable of a design, or a choice with its option in words.
struct SweptVariable {
  std::string name, unit;
  double number = 0;       ///< of a choice in words, not a number
  std::string words = {};  ///< of a choice
  bool at_lower = false, at_upper = false;
};

class SweepStudy {
 public:
  /// `text` is that of a problem file with one objective, or for evaluation one or more. Throws
  /// std::invalid_argument where a word that is swept is misspelt, or where of a name or a sampling
  /// no value can be stated. Of the other values that a problem cannot take the outcome says why.
  SweepStudy(const std::string& text, const std::string& source, const SweepSettings& settings,
             HeldFiles files = {});
  /// As a record has it.
  static SweepStudy of(const optim::StudySettings& settings);
  /// Whether a record is of a sweep.
  static bool is_sweep(const optim::StudySettings& settings);

  const SweepPlan& plan() const { return plan_; }
  /// Whether a name that is swept is a variable of the search, of which only the start is swept.
  bool is_start(const SweptName& name) const;
  /// The file with what is the same in all combinations.
  const ProblemStatement& statement() const { return statement_; }
  const optim::OptimiseOptions& options() const { return options_; }
  optim::OptimiseOptions& options() { return options_; }

  /// What a record keeps of it: problem, settings, versions.
  optim::StudySettings settings() const;
  /// Throws std::invalid_argument naming what differs, where a record is of another study.
  void check_same(const optim::StudyRecord& record) const;

  /// The problem of a combination, or why it cannot be stated.
  Possible<ProblemStatement> stated(std::size_t combination) const;

  /// Carries out a task of this study: its part is the combination, its start, where there is one,
  /// the design of a neighbour as a record has it.
  optim::Outcome carry_out(const optim::Task& task, const optim::OptimiseOptions& options) const;
  /// The problem that a design of a combination is of. A design as records have it is the values of
  /// the variables, then the number of the option taken of each choice.
  optim::Problem problem(std::size_t combination, optim::Design recorded) const;
  /// What that design consists of.
  std::vector<SweptVariable> variables(std::size_t combination, optim::Design recorded) const;
  /// The design as a person states it.
  ProblemStatement design(std::size_t combination, optim::Design recorded) const;

  /// Works out all combinations, or until the options' stop flag is set.
  SweptCombinations run(optim::Executor& executor,
                        const std::function<void(const SweepProgress&)>& progress = {}) const;

 private:
  void check_values();
  bool is_law(const std::string& text);
  bool is_well_written(const SweepAxis& axis, std::size_t value);
  Possible<BoundProblem> bound(std::size_t combination) const;
  bool begins_at_neighbour(const optim::Task& task) const;
  optim::Outcome searched(const optim::Task& task, const BoundProblem& bound,
                          const optim::OptimiseOptions& options) const;

  SweepPlan plan_;
  ProblemStatement statement_;
  optim::OptimiseOptions options_;
};

}  // namespace camlaw::problems
