// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>

#include "optim/pareto/executor.h"

/// A study on disk: every search with all that came of it, written as it is done, so that a study
/// which was cut short goes on where it stood. One SQLite file; its tables: docs/design.md,
/// "Studies".
namespace camlaw::optim {

/// What a study is of, as pairs of name and text: the problem, the solver, versions. Two studies of
/// the same settings give the same outcomes for the same tasks.
using StudySettings = std::map<std::string, std::string>;

class StudyRecord {
 public:
  /// Makes a new file. Throws std::invalid_argument where there is one already, std::runtime_error
  /// where it cannot be written.
  static StudyRecord create(const std::string& path, const StudySettings& settings);
  /// Opens a study to go on with it. Throws std::invalid_argument for what is no study of this
  /// kind, or is damaged, and leaves that as it is.
  static StudyRecord open(const std::string& path);
  /// Opens it to be read alone.
  static StudyRecord read(const std::string& path);

  StudyRecord(StudyRecord&&) noexcept;
  ~StudyRecord();

  StudySettings settings() const;
  /// Sets these, whatever they were. Throws std::runtime_error where it cannot be written.
  void put(const StudySettings& settings);
  /// Throws std::invalid_argument where what is found is damaged. `problem` is that of the task's
  /// part.
  std::optional<Outcome> find(const Task& task, const MultiProblem& problem) const;
  /// Throws std::runtime_error where it cannot be written, such as on a full disk; then nothing of
  /// the outcome is on it. `problem` is that of the task's part, for the names.
  void add(const Task& task, const Outcome& outcome, const MultiProblem& problem);
  std::size_t size() const;

 private:
  class File;
  explicit StudyRecord(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

/// What a record has is taken from it; the rest another executor carries out, and the record takes
/// it down. Without one the study stops at the first task that is not there.
class RecordedExecutor final : public Executor {
 public:
  RecordedExecutor(const MultiSpace& space, StudyRecord& record, Executor* others)
      : space_(space), record_(record), others_(others) {}
  std::vector<Outcome> run(const std::vector<Task>& tasks, const OnOutcome& on_outcome) override;
  std::string remark() const override { return others_ == nullptr ? "" : others_->remark(); }

 private:
  const MultiSpace& space_;
  StudyRecord& record_;
  Executor* others_;
};

/// "sqlite 3.40.1".
std::string sqlite_version();

}  // namespace camlaw::optim
