// SPDX-License-Identifier: MIT
#include "numerics/text/csv_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

[[noreturn]] void refuse(std::size_t line, const std::string& why) {
  throw std::invalid_argument(fmt::format("line {}: {}", line, why));
}

std::vector<std::string> cells_of(std::string_view text, std::size_t line) {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_pair = quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"';
    if (is_pair) {
      cells.back() += c;
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  if (quoted) refuse(line, "a quote does not end");
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

}  // namespace

std::vector<CsvRow> csv_rows(std::string_view text, const std::vector<std::string>& columns) {
  std::vector<CsvRow> rows;
  std::vector<std::string> names;
  std::vector<std::size_t> places;
  std::size_t line = 0;
  while (!text.empty()) {
    ++line;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::vector<std::string> cells = cells_of(text.substr(0, end), line);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (names.empty()) {
      names = std::move(cells);
      for (const std::string& column : columns) {
        const auto at = std::find(names.begin(), names.end(), column);
        if (at == names.end()) refuse(line, fmt::format("column '{}' is missing", column));
        places.push_back(static_cast<std::size_t>(at - names.begin()));
      }
      continue;
    }
    if (cells.size() != names.size()) {
      refuse(line, wrong_cells(cells.size(), names.size()));
    }
    rows.push_back({line, {}});
    for (const std::size_t place : places) rows.back().cells.push_back(cells[place]);
  }
  if (names.empty()) refuse(1, "the first line must hold names");
  return rows;
}

std::string wrong_cells(std::size_t count, std::size_t wanted) {
  return fmt::format("{} {}, where the header has {}", count, count == 1 ? "cell" : "cells",
                     wanted);
}

}  // namespace camlaw::problems
