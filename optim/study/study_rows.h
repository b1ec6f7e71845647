// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "optim/pareto/task.h"

/// For a study's tables alone, and not installed: it needs SQLiteCpp.
/// How one outcome becomes rows and rows become an outcome, and the checksum that tells whether
/// they are as they were written.
namespace camlaw::optim {

/// Names a task's row, and those of the designs that it has led to, by their numbers.
struct TaskRows {
  std::int64_t task = 0;
  std::vector<std::int64_t> designs = {};
};

/// Makes the tables of a new file.
void make_tables(SQLite::Database& base);

/// Makes a statement with a value for each question mark. NaN becomes NULL, which is what SQLite
/// makes of it.
template <class... Values>
SQLite::Statement stated(SQLite::Database& base, const char* query, const Values&... values) {
  SQLite::Statement statement(base, query);
  SQLite::bind(statement, values...);
  return statement;
}

/// Writes a task and its outcome, sealed with a checksum, under a number, else the next one.
TaskRows write_rows(SQLite::Database& base, const Task& task, const Outcome& outcome,
                    const Problem& problem, std::optional<std::int64_t> number);
/// Throws std::runtime_error where a row is gone, or holds words that are none of ours.
Outcome read_rows(SQLite::Database& base, const TaskRows& rows, std::size_t part);
void remove_rows(SQLite::Database& base, const TaskRows& rows);

/// Works out the checksum of rows, as it is stored beside them.
std::int64_t checksum_of(SQLite::Database& base, const TaskRows& rows);
/// Works out that of one setting, or of a question and its answer.
std::int64_t checksum_of(const std::string& name, const std::string& value);

/// Writes an answer, in place of an earlier one to the same question.
void write_answer(SQLite::Database& base, const std::string& question, const std::string& answer);
/// None where there is none, or it is not as it was written.
std::optional<std::string> read_answer(SQLite::Database& base, const std::string& question);

}  // namespace camlaw::optim
