// SPDX-License-Identifier: MIT
#include "output/answers/comparison_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "output/document/formatting.h"

namespace camlaw::cli {

RowCell row_number(double value) {
  if (std::isnan(value)) return {};
  return {in_digits(value), to_json(value), {}};
}

std::vector<Cell> marked(const std::vector<RowCell>& row) {
  std::optional<double> best, worst;
  for (const RowCell& cell : row) {
    if (!cell.rank) continue;
    best = std::max(best.value_or(*cell.rank), *cell.rank);
    worst = std::min(worst.value_or(*cell.rank), *cell.rank);
  }
  std::vector<Cell> cells;
  for (const RowCell& its : row) {
    Cell cell(its.text, its.value);
    if (its.rank && *best > *worst && *its.rank == *best) {
      cell.text += ", best";
      cell.badge = "good";
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

ComparisonTable::ComparisonTable(std::string key, Column first,
                                 const std::vector<std::string>& letters, bool with_unit)
    : with_unit_(with_unit) {
  table_.key = std::move(key);
  table_.columns = {std::move(first)};
  if (with_unit) table_.columns.push_back(words("unit", "unit"));
  for (const std::string& letter : letters) table_.columns.push_back(words(letter, letter));
}

void ComparisonTable::add(const std::string& name, const std::string& unit,
                          const std::vector<RowCell>& row) {
  std::vector<Cell> cells{name};
  if (with_unit_) cells.push_back(shown_unit(unit));
  for (Cell& cell : marked(row)) cells.push_back(std::move(cell));
  table_.add(std::move(cells));
}

void take_name(UnitNames& names, const std::string& name, const std::string& unit) {
  const std::pair<std::string, std::string> one{name, unit};
  if (std::find(names.begin(), names.end(), one) == names.end()) names.push_back(one);
}

namespace {

/// "A, B and C".
std::string in_a_row(const std::vector<std::string>& letters) {
  if (letters.size() < 2) return letters.front();
  return fmt::format("{} and {}", fmt::join(letters.begin(), letters.end() - 1, ", "),
                     letters.back());
}

}  // namespace

std::vector<std::string> unshared_words(const std::vector<OwnNames>& all, const std::string& what) {
  std::map<std::string, std::vector<std::string>> owners;  // letters of each name
  std::vector<std::string> order;
  for (const OwnNames& one : all) {
    for (const std::string& name : one.names) {
      std::vector<std::string>& letters = owners[name];
      if (letters.empty()) order.push_back(name);
      if (letters.empty() || letters.back() != one.letter) letters.push_back(one.letter);
    }
  }
  std::map<std::vector<std::string>, std::vector<std::string>> names_of;
  for (const std::string& name : order) {
    if (owners[name].size() < all.size()) names_of[owners[name]].push_back(name);
  }
  std::vector<std::string> words;
  for (const auto& [letters, names] : names_of) {
    words.push_back(fmt::format("Only {} {} the {}{} {}.", in_a_row(letters),
                                letters.size() == 1 ? "has" : "have", what,
                                names.size() == 1 ? "" : "s", fmt::join(names, ", ")));
  }
  return words;
}

}  // namespace camlaw::cli
