// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "optim/study/record.h"
#include "optim/study/study_rows.h"

/// For record.cpp alone, and not installed: it needs SQLiteCpp.
/// The tables of a study's file (docs/design.md, "Studies"): which tasks there are, and which of
/// them are as they were written.
namespace camlaw::optim {

/// Marks the file as ours: "caml" as four bytes, and the version of the tables.
inline constexpr int kStudyApplication = 0x63616d6c;
inline constexpr int kStudyVersion = 3;
/// The earliest version that is read; its rows have no checksums.
inline constexpr int kOldestStudy = 2;
/// The first version whose rows have checksums.
inline constexpr int kWithChecksums = 3;

/// Errors of SQLite pass as SQLite::Exception. Statements are made when they are needed: a study
/// has few searches a second.
class StudyTables {
 public:
  explicit StudyTables(SQLite::Database& base) : base_(base) {}

  /// The tables of a new file.
  void make(const StudySettings& settings);
  /// Reads which tasks there are, and whether each is as it was written.
  void look();
  bool has_checksums() const { return version_ >= kWithChecksums; }

  void put(const StudySettings& settings);
  /// Throws std::runtime_error naming a setting that is not as it was written.
  StudySettings settings();

  /// None where there is no such task, or it is damaged.
  std::optional<Outcome> find(const std::string& text, std::size_t part);
  /// The row's number of a task that find() gives.
  std::optional<std::int64_t> number(const std::string& text);
  void add(const Task& task, const Outcome& outcome, const Problem& problem);
  void forget(const std::vector<std::int64_t>& numbers);
  /// None where there is no answer, or it is not as it was written.
  std::optional<std::string> answer(const std::string& question);
  void put_answer(const std::string& question, const std::string& answer);
  /// Counts the task as damaged: it cannot be what was written.
  void doubt(const std::string& text);

  std::vector<std::int64_t> damaged() const;
  /// Numbers that no task has: below that of one which is whole, or named by a row of a design.
  std::vector<std::int64_t> lost() const { return {lost_.begin(), lost_.end()}; }
  std::vector<RecordedTask> whole();

 private:
  struct Entry {
    TaskRows rows;
    std::string text;
    bool is_whole = true;
  };

  Entry* entry(const std::string& text);
  void look_within();
  void place();
  void look_again_if_changed();
  /// `left`: designs without a task, by its number.
  void find_lost(const std::map<std::int64_t, std::vector<std::int64_t>>& left);
  std::int64_t data_version();
  void insert(const StudySettings& settings);

  SQLite::Database& base_;
  int version_ = kStudyVersion;
  std::int64_t data_version_ = 0;
  std::vector<Entry> entries_;                 ///< by id
  std::set<std::int64_t> lost_;                ///< they are given to the next tasks
  std::map<std::string, std::size_t> places_;  ///< of those that are whole, by text
};

}  // namespace camlaw::optim
