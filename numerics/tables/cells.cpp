// SPDX-License-Identifier: MIT
#include "numerics/tables/cells.h"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/predicate.hpp>
#include <charconv>
#include <limits>

#include "numerics/text/names.h"

namespace camlaw::problems {
namespace {

constexpr std::string_view kBlank = " \t";

/// Where a cell that begins at `from` ends: at the next `between` that stands in no quotes.
std::size_t cell_end(std::string_view line, char between, std::size_t from) {
  const std::string_view separators = between == kBlanks ? kBlank : std::string_view(&between, 1);
  const std::string_view ignored = between == '\t' ? std::string_view(" ") : kBlank;
  const std::size_t first = std::min(line.find_first_not_of(ignored, from), line.size());
  if (first == line.size() || line[first] != '"') {
    return std::min(line.find_first_of(separators, from), line.size());
  }
  bool inside = false;
  for (std::size_t i = first; i < line.size(); ++i) {
    if (line[i] == '"') inside = !inside;  // two in a row are none
    if (!inside && separators.find(line[i]) != std::string_view::npos) return i;
  }
  return line.size();
}

}  // namespace

std::string_view trimmed_cell(std::string_view text) { return trimmed(text, " \t\r\n\""); }

std::vector<std::string_view> cells_of(std::string_view line, char between) {
  std::vector<std::string_view> cells;
  if (between == kBlanks) {  // those around the line separate nothing
    const std::size_t first = line.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return cells;
    line = line.substr(first, line.find_last_not_of(kBlank) - first + 1);
  }
  for (std::size_t from = 0; from <= line.size();) {
    if (between == kBlanks) from = line.find_first_not_of(kBlank, from);
    const std::size_t to = cell_end(line, between, from);
    cells.push_back(trimmed_cell(line.substr(from, to - from)));
    from = to + 1;
  }
  return cells;
}

bool is_missing(std::string_view cell) {
  // What spreadsheets, databases and programs for measurements write, in English and German.
  static constexpr std::array<std::string_view, 25> kMarks{
      "nan",    "-nan",    "n/a",    "na",     "null",   "none",     "nil",    "missing", "-",
      "--",     "---",     "\u2013", "\u2014", "#n/a",   "#n/a n/a", "#na",    "#nv",     "#value!",
      "#wert!", "#div/0!", "#num!",  "#zahl!", "#null!", "#ref!",    "#bezug!"};
  return cell.empty() || std::any_of(kMarks.begin(), kMarks.end(), [cell](std::string_view mark) {
           return boost::algorithm::iequals(cell, mark);
         });
}

bool read_number(std::string_view cell, double& value) {
  if (is_missing(cell)) {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  std::string plain;
  if (cell.find(',') != std::string_view::npos) {
    plain = std::string(cell);
    std::replace(plain.begin(), plain.end(), ',', '.');
    cell = plain;
  }
  if (cell.front() == '+') cell.remove_prefix(1);
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size();
}

int decimals_of(std::string_view cell) {
  const std::size_t e = cell.find_first_of("eE");
  const std::string_view digits = cell.substr(0, e);
  const std::size_t point = digits.find_first_of(".,");
  const std::size_t after = point == std::string_view::npos ? 0 : digits.size() - point - 1;
  int exponent = 0;
  if (e != std::string_view::npos) {
    const std::string_view power = cell.substr(e + (e + 1 < cell.size() && cell[e + 1] == '+') + 1);
    std::from_chars(power.data(), power.data() + power.size(), exponent);
  }
  return static_cast<int>(after) - exponent;
}

}  // namespace camlaw::problems
