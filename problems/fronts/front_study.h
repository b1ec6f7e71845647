// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/pareto.h"
#include "optim/study/record.h"
#include "problems/statement/bind.h"

/// The front of a problem file: from the text to a study on disk and back.
namespace camlaw::problems {

/// How a front is looked for, as far as people say it.
struct FrontSettings {
  std::size_t points = 50;
  optim::ParetoMethod method = optim::ParetoMethod::Automatic;
  std::vector<std::string> set = {};  ///< beside the file, as set_values takes it
  std::optional<bool> scouts = {};    ///< as ParetoOptions has it; of a record, whether it did
  HeldFiles files = {};               ///< that need not be looked for, as a record keeps them
};

inline constexpr std::size_t kMostPoints = 100'000;

/// "auto", "sweep", "nsga2". Throws std::invalid_argument with the known ones.
optim::ParetoMethod parse_method(std::string_view text);
std::string_view to_string(optim::ParetoMethod method);

class FrontStudy {
 public:
  /// `text` is that of a problem file with two objectives or more, `source` names it in errors.
  FrontStudy(const std::string& text, const std::string& source, const FrontSettings& settings);
  /// As a record has it; to be looked at, or gone on with. Throws std::invalid_argument where a law
  /// file of the problem is not what it was.
  static FrontStudy of(const optim::StudyRecord& record);
  /// As settings() of a study has it.
  static FrontStudy of(const optim::StudySettings& settings);
  /// What a record says of how its front is looked for.
  static FrontSettings settings_of(const optim::StudyRecord& record);
  static FrontSettings settings_of(const optim::StudySettings& settings);

  /// The same study, whose problem's responses throw optim::Interrupted once `stop` is set; for
  /// what is worked out of its front.
  FrontStudy with_stop(const std::atomic<bool>* stop) const;

  const BoundProblem& bound() const { return bound_; }
  const optim::ProblemSpace& space() const { return space_; }
  /// Of the search; progress and stop may be set.
  optim::ParetoOptions& options() { return options_; }
  const optim::ParetoOptions& options() const { return options_; }

  /// What a record keeps of it: problem, settings, versions.
  optim::StudySettings settings() const;
  /// Throws std::invalid_argument naming what differs, where the outcomes of a record are not those
  /// that this study would have. Points and method may differ.
  void check_same(const optim::StudyRecord& record) const;

  optim::Front run(optim::Executor& executor) const;

  /// A point of the front as a person states it, for evaluation.
  ProblemStatement design(const optim::FrontPoint& point) const;
  /// The law of a design of the front; none where the mechanism has none.
  std::optional<Member> law(const optim::FrontPoint& point) const;

 private:
  BoundProblem bound_;
  optim::ProblemSpace space_;
  optim::ParetoOptions options_;
};

}  // namespace camlaw::problems
