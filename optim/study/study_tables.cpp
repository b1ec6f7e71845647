// SPDX-License-Identifier: MIT
#include "optim/study/study_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace camlaw::optim {

void StudyTables::make(const StudySettings& settings) {
  SQLite::Transaction all(base_);
  base_.exec(fmt::format("PRAGMA application_id = {}", kStudyApplication));
  base_.exec(fmt::format("PRAGMA user_version = {}", kStudyVersion));
  make_tables(base_);
  insert(settings);
  all.commit();
}

std::int64_t StudyTables::data_version() {
  return base_.execAndGet("PRAGMA data_version").getInt64();
}

void StudyTables::look() {
  SQLite::Transaction all(base_);  // so that what others write meanwhile is not half seen
  look_within();
  all.commit();
}

void StudyTables::look_within() {
  version_ = base_.execAndGet("PRAGMA user_version").getInt();
  entries_.clear();
  std::map<std::int64_t, std::vector<std::int64_t>> designs;
  SQLite::Statement design(base_, "SELECT id, task FROM design ORDER BY id");
  while (design.executeStep()) {
    designs[design.getColumn(1).getInt64()].push_back(design.getColumn(0).getInt64());
  }
  SQLite::Statement task(base_, has_checksums() ? "SELECT id, text, checksum FROM task ORDER BY id"
                                                : "SELECT id, text, 0 FROM task ORDER BY id");
  while (task.executeStep()) {
    const std::int64_t id = task.getColumn(0).getInt64();
    Entry entry{{id, designs[id]}, task.getColumn(1).getString()};
    entry.is_whole =
        !has_checksums() || task.getColumn(2).getInt64() == checksum_of(base_, entry.rows);
    entries_.push_back(std::move(entry));
    designs.erase(id);
  }
  place();
  find_lost(designs);
  data_version_ = data_version();
}

void StudyTables::find_lost(const std::map<std::int64_t, std::vector<std::int64_t>>& left) {
  lost_.clear();
  // A number of a damaged row may be damaged itself.
  std::int64_t last = 0;
  bool all_whole = true;
  for (const Entry& entry : entries_) {
    all_whole = all_whole && entry.is_whole;
    if (entry.is_whole && has_checksums()) last = std::max(last, entry.rows.task);
  }
  auto next = entries_.begin();
  for (std::int64_t number = 1; number < last; ++number) {
    while (next->rows.task < number) ++next;
    if (next->rows.task != number) lost_.insert(number);
  }
  for (const auto& [task, designs] : left) {
    if (task > 0 && all_whole) lost_.insert(task);
  }
}

void StudyTables::look_again_if_changed() {
  if (data_version() != data_version_) look();
}

StudyTables::Entry* StudyTables::entry(const std::string& text) {
  const auto at = places_.find(text);
  return at == places_.end() ? nullptr : &entries_[at->second];
}

void StudyTables::put(const StudySettings& settings) {
  SQLite::Transaction all(base_);
  insert(settings);
  all.commit();
}

void StudyTables::insert(const StudySettings& settings) {
  for (const auto& [name, value] : settings) {
    stated(base_, "INSERT OR REPLACE INTO setting VALUES (?, ?, ?)", name, value,
           checksum_of(name, value))
        .exec();
  }
}

StudySettings StudyTables::settings() {
  StudySettings result;
  SQLite::Statement rows(base_, has_checksums() ? "SELECT name, value, checksum FROM setting"
                                                : "SELECT name, value, 0 FROM setting");
  while (rows.executeStep()) {
    const std::string name = rows.getColumn(0).getString(), value = rows.getColumn(1).getString();
    if (has_checksums() && rows.getColumn(2).getInt64() != checksum_of(name, value)) {
      throw std::runtime_error(fmt::format("its setting '{}' is not as it was written", name));
    }
    result[name] = value;
  }
  return result;
}

std::optional<Outcome> StudyTables::find(const std::string& text, std::size_t part) {
  if (entry(text) == nullptr) look_again_if_changed();
  const Entry* found = entry(text);
  if (found == nullptr) return {};
  try {
    return read_rows(base_, found->rows, part);
  } catch (const SQLite::Exception&) {
    throw;
  } catch (const std::runtime_error&) {  // words that are none of ours
    doubt(text);
    return {};
  }
}

std::optional<std::int64_t> StudyTables::number(const std::string& text) {
  const Entry* found = entry(text);
  return found == nullptr ? std::nullopt : std::optional(found->rows.task);
}

void StudyTables::doubt(const std::string& text) {
  Entry* found = entry(text);
  if (found == nullptr) return;
  found->is_whole = false;
  places_.erase(text);
}

std::vector<std::int64_t> StudyTables::damaged() const {
  std::vector<std::int64_t> numbers;
  for (const Entry& entry : entries_) {
    if (!entry.is_whole) numbers.push_back(entry.rows.task);
  }
  return numbers;
}

std::vector<RecordedTask> StudyTables::whole() {
  std::vector<RecordedTask> tasks;
  for (Entry& entry : entries_) {
    if (!entry.is_whole) continue;
    auto task = stated(base_, "SELECT part FROM task WHERE id = ?", entry.rows.task);
    if (!task.executeStep()) continue;
    const auto part = static_cast<std::size_t>(task.getColumn(0).getInt64());
    try {
      tasks.push_back({entry.rows.task, part, entry.text, read_rows(base_, entry.rows, part)});
    } catch (const SQLite::Exception&) {
      throw;
    } catch (const std::runtime_error&) {
      doubt(std::string(entry.text));
    }
  }
  return tasks;
}

void StudyTables::add(const Task& task, const Outcome& outcome, const Problem& problem) {
  SQLite::Transaction all(base_, SQLite::TransactionBehavior::IMMEDIATE);
  if (data_version() != data_version_) look_within();
  const std::string text = task.text();
  if (const Entry* there = entry(text)) {
    auto died = stated(base_, "SELECT died FROM task WHERE id = ?", there->rows.task);
    if (!died.executeStep() || died.getColumn(0).getInt() == 0) return;  // what is there stays
  }
  std::optional<std::int64_t> number;  // of what it replaces, else of what is lost, else the next
  if (!lost_.empty()) number = *lost_.begin();
  for (const Entry& entry : entries_) {
    if (entry.text != text) continue;
    remove_rows(base_, entry.rows);
    number = entry.rows.task;
  }
  Entry entry{write_rows(base_, task, outcome, problem, number), text};
  all.commit();
  lost_.erase(entry.rows.task);
  const auto by_number = [](const Entry& a, const Entry& b) { return a.rows.task < b.rows.task; };
  const auto replaced =
      std::erase_if(entries_, [&](const Entry& other) { return other.text == text; });
  const bool is_last = entries_.empty() || entries_.back().rows.task < entry.rows.task;
  entries_.push_back(std::move(entry));
  if (!is_last) std::sort(entries_.begin(), entries_.end(), by_number);
  if (replaced > 0 || !is_last) return place();
  places_[text] = entries_.size() - 1;  // of a study of 10^4 tasks the others stay as they are
}

std::optional<std::string> StudyTables::answer(const std::string& question) {
  return read_answer(base_, question);
}

void StudyTables::put_answer(const std::string& question, const std::string& answer) {
  write_answer(base_, question, answer);
}

void StudyTables::place() {
  places_.clear();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].is_whole) {
      entries_[i].is_whole = places_.try_emplace(entries_[i].text, i).second;
    }
  }
}

void StudyTables::forget(const std::vector<std::int64_t>& numbers) {
  SQLite::Transaction all(base_, SQLite::TransactionBehavior::IMMEDIATE);
  for (const Entry& entry : entries_) {
    if (std::find(numbers.begin(), numbers.end(), entry.rows.task) != numbers.end())
      remove_rows(base_, entry.rows);
  }
  // What belongs to nothing would come to belong to what gets its number.
  base_.exec("DELETE FROM design WHERE task NOT IN (SELECT id FROM task)");
  for (const char* table : {"variable", "objective", "margin"}) {
    base_.exec(fmt::format("DELETE FROM {} WHERE design NOT IN (SELECT id FROM design)", table));
  }
  all.commit();
  look();
}

}  // namespace camlaw::optim
