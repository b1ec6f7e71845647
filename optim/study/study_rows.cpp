// SPDX-License-Identifier: MIT
#include "optim/study/study_rows.h"

#include <fmt/format.h>

#include <bit>
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
CREATE TABLE answer (
  question BLOB PRIMARY KEY, answer BLOB NOT NULL, checksum INTEGER NOT NULL) WITHOUT ROWID;
)";

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double number_in(const SQLite::Column& column) {
  return column.isNull() ? kNone : column.getDouble();
}

Verdict verdict_of(const std::string& text) {
  for (const Verdict v :
       {Verdict::Certified, Verdict::Feasible, Verdict::Infeasible, Verdict::Failed}) {
    if (to_string(v) == text) return v;
  }
  throw std::runtime_error(fmt::format("'{}' is not a verdict", text));
}

/// Adds a row as SQLite holds it, each value with its type.
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

/// Adds all rows of a query about one id.
void add_rows(Checksum& checksum, SQLite::Database& base, const char* query, std::int64_t id) {
  checksum.add('T', std::string_view(query));
  auto rows = stated(base, query, id);
  while (rows.executeStep()) add_row(checksum, rows);
}

std::int64_t as_stored(const Checksum& checksum) {
  return std::bit_cast<std::int64_t>(checksum.value());
}

FrontPoint design_of(SQLite::Database& base, std::int64_t id, std::size_t part) {
  const auto rows = [&](const char* query) { return stated(base, query, id); };
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

std::int64_t add_design(SQLite::Database& base, std::int64_t task, const FrontPoint& point,
                        const Problem& problem) {
  stated(base,
         "INSERT INTO design (task, verdict, reason, is_global, solver) VALUES (?, ?, ?, ?, ?)",
         task, std::string(to_string(point.verdict)), point.reason, point.is_global, point.solver)
      .exec();
  const std::int64_t design = base.getLastInsertRowid();
  const auto number = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    const Variable& v = problem.variables.at(i);
    stated(base, "INSERT INTO variable VALUES (?, ?, ?, ?, ?)", design, number(i), v.name, v.unit,
           point.x[i])
        .exec();
  }
  for (std::size_t i = 0; i < point.costs.size(); ++i) {
    const Response& sought = problem.objectives.at(i).response;
    stated(base, "INSERT INTO objective VALUES (?, ?, ?, ?, ?, ?, ?)", design, number(i),
           sought.name, sought.unit, point.objectives[i], point.costs[i],
           point.weights.empty() ? kNone : point.weights[i])
        .exec();
  }
  for (std::size_t i = 0; i < point.limits.size(); ++i) {
    const Standing& limit = point.limits[i];
    stated(base, "INSERT INTO margin VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", design, number(i),
           limit.name, limit.unit, limit.margin, limit.angle.value_or(kNone), limit.met,
           limit.proved, limit.price)
        .exec();
  }
  return design;
}

}  // namespace

void make_tables(SQLite::Database& base) { base.exec(kTables); }

TaskRows write_rows(SQLite::Database& base, const Task& task, const Outcome& outcome,
                    const Problem& problem, std::optional<std::int64_t> number) {
  const std::int64_t next =
      number ? *number : base.execAndGet("SELECT ifnull(max(id), 0) + 1 FROM task").getInt64();
  stated(base,
         "INSERT INTO task (id, text, part, infeasible, evaluations, failure, died, is_global, "
         "checksum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, 0)",
         next, task.text(), static_cast<std::int64_t>(task.part), outcome.infeasible,
         static_cast<std::int64_t>(outcome.evaluations), outcome.failure, outcome.died,
         outcome.is_global)
      .exec();
  TaskRows rows{base.getLastInsertRowid()};
  for (const FrontPoint& point : outcome.points) {
    rows.designs.push_back(add_design(base, rows.task, point, problem));
  }
  stated(base, "UPDATE task SET checksum = ? WHERE id = ?", checksum_of(base, rows), rows.task)
      .exec();
  return rows;
}

void remove_rows(SQLite::Database& base, const TaskRows& rows) {
  for (const std::int64_t design : rows.designs) {
    stated(base, "DELETE FROM variable WHERE design = ?", design).exec();
    stated(base, "DELETE FROM objective WHERE design = ?", design).exec();
    stated(base, "DELETE FROM margin WHERE design = ?", design).exec();
  }
  stated(base, "DELETE FROM design WHERE task = ?", rows.task).exec();
  stated(base, "DELETE FROM task WHERE id = ?", rows.task).exec();
}

Outcome read_rows(SQLite::Database& base, const TaskRows& rows, std::size_t part) {
  auto task = stated(base,
                     "SELECT infeasible, evaluations, failure, died, is_global FROM task "
                     "WHERE id = ?",
                     rows.task);
  Outcome outcome;
  if (!task.executeStep()) throw std::runtime_error("the task is gone");
  outcome.infeasible = task.getColumn(0).getInt() != 0;
  outcome.evaluations = task.getColumn(1).getInt64();
  outcome.failure = task.getColumn(2).getString();
  outcome.died = task.getColumn(3).getInt() != 0;
  outcome.is_global = task.getColumn(4).getInt() != 0;
  for (const std::int64_t design : rows.designs) {
    outcome.points.push_back(design_of(base, design, part));
  }
  return outcome;
}

std::int64_t checksum_of(SQLite::Database& base, const TaskRows& rows) {
  Checksum checksum;
  add_rows(checksum, base,
           "SELECT id, text, part, infeasible, evaluations, failure, died, is_global FROM task "
           "WHERE id = ?",
           rows.task);
  for (const std::int64_t design : rows.designs) {
    add_rows(checksum, base,
             "SELECT id, task, verdict, reason, is_global, solver FROM design WHERE id = ?",
             design);
    add_rows(checksum, base,
             "SELECT design, place, name, unit, value FROM variable WHERE design = ? "
             "ORDER BY place",
             design);
    add_rows(checksum, base,
             "SELECT design, place, name, unit, value, cost, weight FROM objective "
             "WHERE design = ? ORDER BY place",
             design);
    add_rows(checksum, base,
             "SELECT design, place, name, unit, margin, angle, met, proved, price FROM margin "
             "WHERE design = ? ORDER BY place",
             design);
  }
  return as_stored(checksum);
}

std::int64_t checksum_of(const std::string& name, const std::string& value) {
  Checksum checksum;
  checksum.add('t', std::string_view(name));
  checksum.add('t', std::string_view(value));
  return as_stored(checksum);
}

void write_answer(SQLite::Database& base, const std::string& question, const std::string& answer) {
  SQLite::Statement row(base, "INSERT OR REPLACE INTO answer VALUES (?, ?, ?)");
  row.bind(1, question.data(), static_cast<int>(question.size()));
  row.bind(2, answer.data(), static_cast<int>(answer.size()));
  row.bind(3, checksum_of(question, answer));
  row.exec();
}

std::optional<std::string> read_answer(SQLite::Database& base, const std::string& question) {
  SQLite::Statement row(base, "SELECT answer, checksum FROM answer WHERE question = ?");
  row.bind(1, question.data(), static_cast<int>(question.size()));
  if (!row.executeStep()) return {};
  const SQLite::Column bytes = row.getColumn(0);
  std::string answer(static_cast<const char*>(bytes.getBlob()),
                     static_cast<std::size_t>(bytes.getBytes()));
  if (row.getColumn(1).getInt64() != checksum_of(question, answer)) return {};
  return answer;
}

}  // namespace camlaw::optim
