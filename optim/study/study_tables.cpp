// SPDX-License-Identifier: MIT
#include "optim/study/study_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "optim/study/checksum.h"

namespace camlaw::optim {
namespace {

/// Without indices: what they hold twice could be damaged twice, and a study's tasks fit into
/// memory (look()).
constexpr const char* kTables = R"(
CREATE TABLE setting (
  name TEXT PRIMARY KEY, value TEXT NOT NULL, checksum INTEGER NOT NULL) WITHOUT ROWID;
CREATE TABLE task (
  id INTEGER PRIMARY KEY, text TEXT NOT NULL, part INTEGER NOT NULL,
  infeasible INTEGER NOT NULL, evaluations INTEGER NOT NULL, failure TEXT NOT NULL,
  died INTEGER NOT NULL, is_global INTEGER NOT NULL, checksum INTEGER NOT NULL);
CREATE TABLE design (
  id INTEGER PRIMARY KEY, task INTEGER NOT NULL REFERENCES task(id), verdict TEXT NOT NULL,
  reason TEXT NOT NULL, is_global INTEGER NOT NULL, solver TEXT NOT NULL);
CREATE TABLE variable (
  design INTEGER NOT NULL REFERENCES design(id), place INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, value REAL, PRIMARY KEY (design, place)) WITHOUT ROWID;
CREATE TABLE objective (
  design INTEGER NOT NULL REFERENCES design(id), place INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, value REAL, cost REAL, weight REAL,
  PRIMARY KEY (design, place)) WITHOUT ROWID;
CREATE TABLE margin (
  design INTEGER NOT NULL REFERENCES design(id), place INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, margin REAL, angle REAL, met INTEGER NOT NULL, proved INTEGER NOT NULL,
  price REAL, PRIMARY KEY (design, place)) WITHOUT ROWID;
)";

double number_in(const SQLite::Column& column) {
  return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
}

/// NaN is kept as NULL, which is what SQLite makes of it.
void bind(SQLite::Statement& statement, int index, double value) {
  std::isnan(value) ? statement.bind(index) : statement.bind(index, value);
}

Verdict verdict_of(const std::string& text) {
  for (const Verdict v :
       {Verdict::Certified, Verdict::Feasible, Verdict::Infeasible, Verdict::Failed}) {
    if (to_string(v) == text) return v;
  }
  throw std::runtime_error(fmt::format("'{}' is not a verdict", text));
}

std::int64_t whole_number(std::size_t n) { return static_cast<std::int64_t>(n); }

std::int64_t as_stored(std::uint64_t checksum) { return std::bit_cast<std::int64_t>(checksum); }

/// A row as SQLite holds it, each value with its type.
void add_row(Checksum& checksum, SQLite::Statement& row) {
  checksum.add('R', static_cast<std::int64_t>(row.getColumnCount()));
  for (int i = 0; i < row.getColumnCount(); ++i) {
    const SQLite::Column column = row.getColumn(i);
    if (column.isInteger()) {
      checksum.add('i', static_cast<std::int64_t>(column.getInt64()));
    } else if (column.isFloat()) {
      checksum.add('r', column.getDouble());
    } else if (column.isNull()) {
      checksum.add('n', std::int64_t{0});
    } else {
      checksum.add(column.isText() ? 't' : 'b', std::string_view(column.getString()));
    }
  }
}

/// All rows of a query about one id.
void add_rows(Checksum& checksum, SQLite::Database& base, const char* query, std::int64_t id) {
  SQLite::Statement rows(base, query);
  rows.bind(1, id);
  checksum.add('T', std::string_view(query));
  while (rows.executeStep()) add_row(checksum, rows);
}

std::uint64_t setting_checksum(const std::string& name, const std::string& value) {
  Checksum checksum;
  checksum.add('t', std::string_view(name));
  checksum.add('t', std::string_view(value));
  return checksum.value();
}

}  // namespace

void StudyTables::make(const StudySettings& settings) {
  SQLite::Transaction all(base_);
  base_.exec(fmt::format("PRAGMA application_id = {}", kStudyApplication));
  base_.exec(fmt::format("PRAGMA user_version = {}", kStudyVersion));
  base_.exec(kTables);
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
    Entry entry{task.getColumn(0).getInt64(), task.getColumn(1).getString(), {}, true};
    entry.designs = std::move(designs[entry.id]);
    entry.is_whole =
        !has_checksums() || task.getColumn(2).getInt64() == as_stored(checksum_of(entry));
    entries_.push_back(std::move(entry));
  }
  place();
  data_version_ = data_version();
}

void StudyTables::look_again_if_changed() {
  if (data_version() != data_version_) look();
}

StudyTables::Entry* StudyTables::entry(const std::string& text) {
  const auto at = places_.find(text);
  return at == places_.end() ? nullptr : &entries_[at->second];
}

std::uint64_t StudyTables::checksum_of(const Entry& entry) {
  Checksum checksum;
  add_rows(checksum, base_,
           "SELECT id, text, part, infeasible, evaluations, failure, died, is_global FROM task "
           "WHERE id = ?",
           entry.id);
  for (const std::int64_t design : entry.designs) {
    add_rows(checksum, base_,
             "SELECT id, task, verdict, reason, is_global, solver FROM design WHERE id = ?",
             design);
    add_rows(checksum, base_,
             "SELECT design, place, name, unit, value FROM variable WHERE design = ? "
             "ORDER BY place",
             design);
    add_rows(checksum, base_,
             "SELECT design, place, name, unit, value, cost, weight FROM objective "
             "WHERE design = ? ORDER BY place",
             design);
    add_rows(checksum, base_,
             "SELECT design, place, name, unit, margin, angle, met, proved, price FROM margin "
             "WHERE design = ? ORDER BY place",
             design);
  }
  return checksum.value();
}

void StudyTables::put(const StudySettings& settings) {
  SQLite::Transaction all(base_);
  insert(settings);
  all.commit();
}

void StudyTables::insert(const StudySettings& settings) {
  for (const auto& [name, value] : settings) {
    SQLite::Statement insert(base_, "INSERT OR REPLACE INTO setting VALUES (?, ?, ?)");
    insert.bind(1, name);
    insert.bind(2, value);
    insert.bind(3, as_stored(setting_checksum(name, value)));
    insert.exec();
  }
}

StudySettings StudyTables::settings() {
  StudySettings result;
  SQLite::Statement rows(base_, has_checksums() ? "SELECT name, value, checksum FROM setting"
                                                : "SELECT name, value, 0 FROM setting");
  while (rows.executeStep()) {
    const std::string name = rows.getColumn(0).getString(), value = rows.getColumn(1).getString();
    if (has_checksums() &&
        rows.getColumn(2).getInt64() != as_stored(setting_checksum(name, value))) {
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
    return outcome_of(*found, part);
  } catch (const SQLite::Exception&) {
    throw;
  } catch (const std::runtime_error&) {  // words that are none of ours
    doubt(text);
    return {};
  }
}

std::optional<std::int64_t> StudyTables::number(const std::string& text) {
  const Entry* found = entry(text);
  return found == nullptr ? std::nullopt : std::optional(found->id);
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
    if (!entry.is_whole) numbers.push_back(entry.id);
  }
  return numbers;
}

std::vector<RecordedTask> StudyTables::whole() {
  std::vector<RecordedTask> tasks;
  for (Entry& entry : entries_) {
    if (!entry.is_whole) continue;
    SQLite::Statement task(base_, "SELECT part FROM task WHERE id = ?");
    task.bind(1, entry.id);
    if (!task.executeStep()) continue;
    const auto part = static_cast<std::size_t>(task.getColumn(0).getInt64());
    try {
      tasks.push_back({entry.id, part, entry.text, outcome_of(entry, part)});
    } catch (const SQLite::Exception&) {
      throw;
    } catch (const std::runtime_error&) {
      doubt(std::string(entry.text));
    }
  }
  return tasks;
}

Outcome StudyTables::outcome_of(const Entry& entry, std::size_t part) {
  SQLite::Statement task(base_,
                         "SELECT infeasible, evaluations, failure, died, is_global FROM task "
                         "WHERE id = ?");
  task.bind(1, entry.id);
  Outcome outcome;
  if (!task.executeStep()) throw std::runtime_error("the task is gone");
  outcome.infeasible = task.getColumn(0).getInt() != 0;
  outcome.evaluations = task.getColumn(1).getInt64();
  outcome.failure = task.getColumn(2).getString();
  outcome.died = task.getColumn(3).getInt() != 0;
  outcome.is_global = task.getColumn(4).getInt() != 0;
  for (const std::int64_t design : entry.designs) {
    outcome.points.push_back(design_of(design, part));
  }
  return outcome;
}

FrontPoint StudyTables::design_of(std::int64_t id, std::size_t part) {
  const auto rows = [&](const char* query) {
    SQLite::Statement statement(base_, query);
    statement.bind(1, id);
    return statement;
  };
  auto design = rows("SELECT verdict, reason, is_global, solver FROM design WHERE id = ?");
  if (!design.executeStep()) throw std::runtime_error("the design is gone");
  FrontPoint point;
  point.part = part;
  point.verdict = verdict_of(design.getColumn(0).getString());
  point.reason = design.getColumn(1).getString();
  point.is_global = design.getColumn(2).getInt() != 0;
  point.solver = design.getColumn(3).getString();
  auto variable = rows("SELECT value FROM variable WHERE design = ? ORDER BY place");
  while (variable.executeStep()) point.x.push_back(number_in(variable.getColumn(0)));
  auto objective =
      rows("SELECT value, cost, weight FROM objective WHERE design = ? ORDER BY place");
  while (objective.executeStep()) {
    point.objectives.push_back(number_in(objective.getColumn(0)));
    point.costs.push_back(number_in(objective.getColumn(1)));
    if (!objective.getColumn(2).isNull()) {
      point.weights.push_back(objective.getColumn(2).getDouble());
    }
  }
  auto margin = rows(
      "SELECT name, unit, margin, angle, met, proved, price FROM margin WHERE design = ? "
      "ORDER BY place");
  while (margin.executeStep()) {
    Standing limit;
    limit.name = margin.getColumn(0).getString();
    limit.unit = margin.getColumn(1).getString();
    limit.margin = number_in(margin.getColumn(2));
    if (!margin.getColumn(3).isNull()) limit.angle = margin.getColumn(3).getDouble();
    limit.met = margin.getColumn(4).getInt() != 0;
    limit.proved = margin.getColumn(5).getInt() != 0;
    limit.price = number_in(margin.getColumn(6));
    point.limits.push_back(std::move(limit));
  }
  return point;
}

void StudyTables::add(const Task& task, const Outcome& outcome, const Problem& problem) {
  SQLite::Transaction all(base_, SQLite::TransactionBehavior::IMMEDIATE);
  if (data_version() != data_version_) look_within();
  const std::string text = task.text();
  const Entry* there = entry(text);
  if (there != nullptr && !has_died(*there)) return;  // what is there stays
  for (const Entry& entry : entries_) {
    if (entry.text == text) remove(entry);
  }
  SQLite::Statement insert(base_,
                           "INSERT INTO task (text, part, infeasible, evaluations, failure, died, "
                           "is_global, checksum) VALUES (?, ?, ?, ?, ?, ?, ?, 0)");
  insert.bind(1, text);
  insert.bind(2, whole_number(task.part));
  insert.bind(3, outcome.infeasible);
  insert.bind(4, static_cast<std::int64_t>(outcome.evaluations));
  insert.bind(5, outcome.failure);
  insert.bind(6, outcome.died);
  insert.bind(7, outcome.is_global);
  insert.exec();
  Entry entry{base_.getLastInsertRowid(), text, {}, true};
  for (const FrontPoint& point : outcome.points) {
    entry.designs.push_back(add_design(entry.id, point, problem));
  }
  SQLite::Statement seal(base_, "UPDATE task SET checksum = ? WHERE id = ?");
  seal.bind(1, as_stored(checksum_of(entry)));
  seal.bind(2, entry.id);
  seal.exec();
  all.commit();
  std::erase_if(entries_, [&](const Entry& other) { return other.text == text; });
  entries_.push_back(std::move(entry));
  place();
}

void StudyTables::place() {
  places_.clear();
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].is_whole) {
      entries_[i].is_whole = places_.try_emplace(entries_[i].text, i).second;
    }
  }
}

bool StudyTables::has_died(const Entry& entry) {
  SQLite::Statement task(base_, "SELECT died FROM task WHERE id = ?");
  task.bind(1, entry.id);
  return task.executeStep() && task.getColumn(0).getInt() != 0;
}

void StudyTables::remove(const Entry& entry) {
  const auto run = [&](const char* query, std::int64_t id) {
    SQLite::Statement statement(base_, query);
    statement.bind(1, id);
    statement.exec();
  };
  for (const std::int64_t design : entry.designs) {
    run("DELETE FROM variable WHERE design = ?", design);
    run("DELETE FROM objective WHERE design = ?", design);
    run("DELETE FROM margin WHERE design = ?", design);
  }
  run("DELETE FROM design WHERE task = ?", entry.id);
  run("DELETE FROM task WHERE id = ?", entry.id);
}

void StudyTables::forget(const std::vector<std::int64_t>& numbers) {
  SQLite::Transaction all(base_, SQLite::TransactionBehavior::IMMEDIATE);
  for (const Entry& entry : entries_) {
    if (std::find(numbers.begin(), numbers.end(), entry.id) != numbers.end()) remove(entry);
  }
  // What belongs to nothing would come to belong to what gets its number.
  base_.exec("DELETE FROM design WHERE task NOT IN (SELECT id FROM task)");
  for (const char* table : {"variable", "objective", "margin"}) {
    base_.exec(fmt::format("DELETE FROM {} WHERE design NOT IN (SELECT id FROM design)", table));
  }
  all.commit();
  look();
}

std::int64_t StudyTables::add_design(std::int64_t task, const FrontPoint& point,
                                     const Problem& problem) {
  SQLite::Statement design(base_,
                           "INSERT INTO design (task, verdict, reason, is_global, solver) "
                           "VALUES (?, ?, ?, ?, ?)");
  design.bind(1, task);
  design.bind(2, std::string(to_string(point.verdict)));
  design.bind(3, point.reason);
  design.bind(4, point.is_global);
  design.bind(5, point.solver);
  design.exec();
  const std::int64_t id = base_.getLastInsertRowid();
  add_variables(id, point, problem);
  add_objectives(id, point, problem);
  add_margins(id, point);
  return id;
}

void StudyTables::add_variables(std::int64_t design, const FrontPoint& point,
                                const Problem& problem) {
  SQLite::Statement insert(base_, "INSERT INTO variable VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    insert.bind(1, design);
    insert.bind(2, whole_number(i));
    insert.bind(3, problem.variables.at(i).name);
    insert.bind(4, problem.variables.at(i).unit);
    bind(insert, 5, point.x[i]);
    insert.exec();
    insert.reset();
  }
}

void StudyTables::add_objectives(std::int64_t design, const FrontPoint& point,
                                 const Problem& problem) {
  SQLite::Statement insert(base_, "INSERT INTO objective VALUES (?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < point.costs.size(); ++i) {
    insert.bind(1, design);
    insert.bind(2, whole_number(i));
    insert.bind(3, problem.objectives.at(i).response.name);
    insert.bind(4, problem.objectives.at(i).response.unit);
    bind(insert, 5, point.objectives[i]);
    bind(insert, 6, point.costs[i]);
    point.weights.empty() ? insert.bind(7) : bind(insert, 7, point.weights[i]);
    insert.exec();
    insert.reset();
  }
}

void StudyTables::add_margins(std::int64_t design, const FrontPoint& point) {
  SQLite::Statement insert(base_, "INSERT INTO margin VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < point.limits.size(); ++i) {
    const Standing& limit = point.limits[i];
    insert.bind(1, design);
    insert.bind(2, whole_number(i));
    insert.bind(3, limit.name);
    insert.bind(4, limit.unit);
    bind(insert, 5, limit.margin);
    limit.angle ? insert.bind(6, *limit.angle) : insert.bind(6);
    insert.bind(7, limit.met);
    insert.bind(8, limit.proved);
    bind(insert, 9, limit.price);
    insert.exec();
    insert.reset();
  }
}

}  // namespace camlaw::optim
