// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "numerics/text/file_format.h"
#include "problems/published/table/printed_text.h"
#include "problems/published/table/stated_table.h"
#include "problems/statement/reading.h"
#include "problems/statement/toml_reader.h"

namespace camlaw::problems {
namespace {

using Kind = Entry::Kind;

constexpr FileFormat kTableFormat{"camlaw table", 1};
constexpr std::size_t kMostRows = 2000;

std::string text_or(const Entry& table, const char* key, std::string otherwise) {
  const Entry* entry = find(table, key);
  return entry == nullptr ? std::move(otherwise) : printable_text(*entry);
}

/// A row's entry, so that errors name the row by its id as well.
Entry called_by_id(Entry row, const std::string& id) {
  const std::string before = row.path;
  row.path = fmt::format("{} '{}'", before, id);
  for (Entry& item : row.items) item.path = row.path + item.path.substr(before.size());
  return row;
}

PrintedText read_printed(const Entry& row) {
  const Entry* printed = find(row, "printed");
  if (printed == nullptr) refuse(row, "printed is missing, such as printed = \"12.34 mm\"");
  if (printed->is_number()) {
    refuse(*printed,
           "a number is given; put it in quotes as it is printed, such as \"12.30 mm\", "
           "as zeros at its end count");
  }
  const std::string& text = text_of(*printed);
  return located(*printed, [&] { return read_printed_text(text); });
}

/// What the row sets, in words.
std::string condition_of(const StatedRow& row) {
  std::string condition;
  for (const std::string& setting : row.set) {
    condition += (condition.empty() ? "" : ", ") + setting;
  }
  if (row.at) condition += (condition.empty() ? "at " : ", at ") + *row.at;
  return condition;
}

StatedRow read_row(const Entry& table) {
  expect(table, Kind::Table, "a table with id, response and printed");
  check_keys(table, {"id", "quantity", "response", "law", "set", "at", "condition", "mechanism",
                     "printed", "place"});
  const Entry* id = find(table, "id");
  if (id == nullptr) refuse(table, "id is missing; give each value a name of its own");
  StatedRow row;
  row.where = called_by_id(table, printable_text(*id));
  const Entry& where = row.where;
  const Entry* response = find(where, "response");
  if (response == nullptr) refuse(where, "response is missing; name what the value is of");
  row.response = printable_text(*response);
  row.law = text_or(where, "law", "");
  row.set = texts_of(find(where, "set"));
  row.mechanism = text_or(where, "mechanism", "");
  if (const Entry* at = find(where, "at")) row.at = printable_text(*at);
  const PrintedText printed = read_printed(where);
  row.printed.id = id->text;
  row.printed.number = printed.number;
  row.printed.unit = printed.unit;
  row.printed.quantity = text_or(where, "quantity", row.response);
  row.printed.law = row.law;
  row.printed.place = text_or(where, "place", "");
  row.printed.condition = text_or(where, "condition", condition_of(row));
  return row;
}

std::vector<StatedRow> read_rows(const Entry& file) {
  const Entry* values = find(file, "values");
  std::vector<StatedRow> rows;
  if (values == nullptr) return rows;
  expect(*values, Kind::List, "a list of tables, each headed [[values]]");
  if (values->items.size() > kMostRows) {
    refuse(*values,
           fmt::format("{} values; at most {} are accepted", values->items.size(), kMostRows));
  }
  std::set<std::string> ids;
  for (const Entry& table : values->items) {
    rows.push_back(read_row(table));
    if (!ids.insert(rows.back().printed.id).second) {
      refuse(rows.back().where, "another value has this id");
    }
  }
  return rows;
}

std::vector<ImpliedParameter> read_implied(const Entry& file) {
  const Entry* list = find(file, "implied");
  std::vector<ImpliedParameter> all;
  if (list == nullptr) return all;
  expect(*list, Kind::List, "a list of tables, each headed [[implied]]");
  for (const Entry& table : list->items) {
    expect(table, Kind::Table, "a table with parameter");
    check_keys(table, {"parameter", "set", "lower", "upper"});
    const Entry* parameter = find(table, "parameter");
    if (parameter == nullptr) refuse(table, "parameter is missing; name what is asked for");
    ImpliedParameter implied{table, printable_text(*parameter), texts_of(find(table, "set"))};
    if (const Entry* lower = find(table, "lower")) implied.lower = printable_text(*lower);
    if (const Entry* upper = find(table, "upper")) implied.upper = printable_text(*upper);
    all.push_back(std::move(implied));
  }
  return all;
}

}  // namespace

StatedTable read_stated_table(std::string_view toml, const std::string& source) {
  StatedTable table;
  table.file = parse_toml(toml, source);
  const Entry& file = table.file;
  check_keys(file,
             {"format", "name", "title", "source", "mechanism", "machine", "responses", "constants",
              "law", "program", "laws", "misprints", "notes", "hypotheses", "implied", "values"});
  if (const Entry* format = find(file, "format")) {
    const std::string& stated = text_of(*format);
    located(*format, [&] { kTableFormat.check(stated); });
  }
  table.name = text_or(file, "name", std::filesystem::path(source).stem().string());
  table.title = text_or(file, "title", table.name);
  table.source = text_or(file, "source", "");
  table.laws = text_table_of(find(file, "laws"));
  if (find(file, "misprints") != nullptr) table.allow_misprints = truth_of(file, "misprints");
  table.notes = texts_of(find(file, "notes"));
  table.hypotheses = read_hypotheses(file);
  table.implied = read_implied(file);
  table.rows = read_rows(file);
  if (table.rows.empty() && table.notes.empty()) {
    refuse(file,
           "there are no values; list them, each headed [[values]], with id, response and "
           "printed");
  }
  return table;
}

}  // namespace camlaw::problems
