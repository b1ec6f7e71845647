// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "optim/pareto/task.h"

/// A study on disk: every search with all that came of it, written as it is done, so that a study
/// which was cut short goes on where it stood. One SQLite file; its tables: docs/design.md,
/// "Studies".
namespace camlaw::optim {

/// What a study is of, as pairs of name and text: the problem, the solver, versions. Two studies of
/// the same settings give the same outcomes for the same tasks.
using StudySettings = std::map<std::string, std::string>;

/// A task of a study with what came of it.
struct RecordedTask {
  std::int64_t number = 0;  ///< of its row
  std::size_t part = 0;
  std::string text;  ///< Task::text()
  Outcome outcome;
};

/// Whether a file begins as a study does. Found out without SQLite, which may make files beside it.
bool begins_as_study(const std::string& path);

class StudyRecord {
 public:
  /// Makes a new file, through links. Throws std::invalid_argument where there is one already, or
  /// beside it what SQLite would take for its own; std::runtime_error where it cannot be written.
  static StudyRecord create(const std::string& path, const StudySettings& settings);
  /// Opens a study to go on with it. Throws std::invalid_argument for what is not a study of this
  /// kind, is damaged as a whole, or is of an earlier version, and leaves that as it is.
  static StudyRecord open(const std::string& path);
  /// Goes on with a study, where `resume` and there is one, else makes a new file. What is there is
  /// shown to `check` before anything is written to it; then it takes these settings, as some may
  /// have changed. Throws as create() and open() do, and what `check` throws.
  static StudyRecord begin(const std::string& path, const StudySettings& settings, bool resume,
                           const std::function<void(const StudyRecord&)>& check);
  /// Opens it to be read alone.
  static StudyRecord read(const std::string& path);

  StudyRecord(StudyRecord&&) noexcept;
  ~StudyRecord();

  /// Throws std::invalid_argument naming a setting that is not as it was written.
  StudySettings settings() const;
  /// Sets these, whatever they were. Throws std::runtime_error where it cannot be written.
  void put(const StudySettings& settings);
  /// Whether each row has a checksum. Studies of earlier programs have none: what they say of their
  /// designs is as good as a look at the designs finds it.
  bool has_checksums() const;

  /// None where there is no such task, or its rows were changed after they were written
  /// (`damaged`). `problem` is that of the task's part. Throws std::invalid_argument where the file
  /// cannot be read.
  std::optional<Outcome> find(const Task& task, const Problem& problem) const;
  /// The same, whatever problem its designs are of.
  std::optional<Outcome> find(const Task& task) const;
  /// The number of the task's row, by which it is named.
  std::optional<std::int64_t> number(const Task& task) const;
  /// Tasks whose rows are not as they were written, as far as was looked, by number.
  std::vector<std::int64_t> damaged() const;
  /// Numbers of tasks whose rows are gone: tasks are numbered from 1 without a gap, and no row of a
  /// design is without its task.
  std::vector<std::int64_t> lost() const;
  /// All that are, by number.
  std::vector<RecordedTask> whole() const;

  /// Throws std::runtime_error where it cannot be written, such as on a full disk; then nothing of
  /// the outcome is on it. `problem` is that of the task's part, for the names.
  void add(const Task& task, const Outcome& outcome, const Problem& problem);
  /// Removes tasks, and what is left of lost ones, so that they are carried out again.
  void forget(const std::vector<std::int64_t>& numbers);
  /// Of work that is not made of searches (recorded_hands.h): the answer to an order. None where
  /// there is none, or its row is not as it was written.
  std::optional<std::string> answer(const std::string& order) const;
  /// Throws as add() does.
  void put_answer(const std::string& order, const std::string& answer);
  /// Of tasks.
  std::size_t size() const;
  /// Whether the study was read without the log that a killed program has left: then it may lack
  /// its last searches.
  bool lost_log() const;
  /// Whether NSGA-II chose its first designs; none while there is no task.
  std::optional<bool> scouted() const;

 private:
  class File;
  explicit StudyRecord(std::unique_ptr<File> file);
  template <class Does>
  auto reading(Does does) const;
  template <class Does>
  void writing(Does does);
  std::unique_ptr<File> file_;
};

/// "sqlite 3.40.1".
std::string sqlite_version();

}  // namespace camlaw::optim
