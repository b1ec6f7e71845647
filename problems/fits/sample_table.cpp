// SPDX-License-Identifier: MIT
#include "problems/fits/sample_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/predicate.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace camlaw::problems {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\"";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// Where a cell that begins at `from` ends: at the next `between` that stands in no quotes.
std::size_t cell_end(std::string_view line, char between, std::size_t from) {
  std::size_t first = from;
  while (first < line.size() && line[first] != between &&
         (line[first] == ' ' || line[first] == '\t')) {
    ++first;
  }
  if (first == line.size() || line[first] != '"')
    return std::min(line.find(between, from), line.size());
  bool inside = false;
  for (std::size_t i = first; i < line.size(); ++i) {
    if (line[i] == '"') inside = !inside;  // two in a row are none
    if (line[i] == between && !inside) return i;
  }
  return line.size();
}

/// Calls take(cell) for each cell of a line.
template <class F>
void for_cells(std::string_view line, char between, F take) {
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = cell_end(line, between, from);
    take(trimmed(line.substr(from, to - from)));
    from = to + 1;
  }
}

/// The first of semicolon and tab that stands outside of quotes, else the comma.
char delimiter_of(std::string_view header) {
  for (const char c : {';', '\t'}) {
    if (cell_end(header, c, 0) < header.size()) return c;
  }
  return ',';
}

/// "lift [mm]" or "lift (mm)".
SampleColumn named(std::string_view cell) {
  const std::size_t open = cell.find_first_of("[(");
  const std::size_t close = cell.find_last_of("])");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
    return {.name = std::string(cell), .unit = "", .values = {}};
  }
  return {.name = std::string(trimmed(cell.substr(0, open))),
          .unit = std::string(trimmed(cell.substr(open + 1, close - open - 1))),
          .values = {}};
}

/// A number; NaN for an empty cell and for "nan", none for anything else.
bool read_number(std::string_view cell, char between, double& value) {
  const bool none = cell.empty() || boost::algorithm::iequals(cell, "nan") ||
                    boost::algorithm::iequals(cell, "n/a") || boost::algorithm::iequals(cell, "na");
  if (none) {
    value = kNaN;
    return true;
  }
  std::string plain;
  if (between != ',' && cell.find(',') != std::string_view::npos) {
    plain = std::string(cell);
    std::replace(plain.begin(), plain.end(), ',', '.');
    cell = plain;
  }
  if (cell.front() == '+') cell.remove_prefix(1);
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size();
}

/// How many digits after the point a number is written with; below 0 of 1e3.
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

/// How often numbers of a column have so many decimals.
class Decimals {
 public:
  void take(int decimals) {
    ++counts_[static_cast<std::size_t>(std::clamp(decimals, -kMost, kMost) + kMost)];
  }
  /// One in the last digit that half of the cells have or go beyond; 0 where none tells.
  double last_digit() const {
    std::size_t all = 0, so_far = 0;
    for (const std::size_t count : counts_) all += count;
    if (all == 0) return 0;
    for (int k = -kMost; k <= kMost; ++k) {
      so_far += counts_[static_cast<std::size_t>(k + kMost)];
      if (2 * so_far >= all) return std::pow(10.0, -k);
    }
    return 0;
  }

 private:
  static constexpr int kMost = 30;
  std::array<std::size_t, 2 * kMost + 1> counts_{};
};

void check_rows(const SampleTable& table) {
  const std::size_t rows = table.rows();
  if (rows >= 2) return;
  throw std::invalid_argument(fmt::format("{}: it has {} row{} of numbers; two at least are wanted",
                                          table.source, rows, rows == 1 ? "" : "s"));
}

void check_name(const SampleTable& table, const std::string& name) {
  if (name.empty()) {
    throw std::invalid_argument(fmt::format("{}: a column has no name", table.source));
  }
  const auto count = std::count_if(table.columns.begin(), table.columns.end(),
                                   [&](const SampleColumn& c) { return c.name == name; });
  if (count < 2) return;
  throw std::invalid_argument(fmt::format("{}: column '{}' is there twice", table.source, name));
}

class Reader {
 public:
  explicit Reader(std::string source) { table_.source = std::move(source); }

  void take(std::string_view line) {
    ++line_;
    if (trimmed(line).empty() || trimmed(line).front() == '#') return;
    table_.columns.empty() ? read_header(line) : read_row(line);
  }

  SampleTable ended() {
    if (table_.columns.empty()) refuse("it is empty; a header and rows of numbers are wanted");
    check_rows(table_);
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      SampleColumn& column = table_.columns[i];
      column.last_digit = decimals_[i].last_digit();
      const auto numbers = std::count_if(column.values.begin(), column.values.end(),
                                         [](double value) { return !std::isnan(value); });
      column.is_text = texts_[i] > static_cast<std::size_t>(numbers);
    }
    return std::move(table_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw std::invalid_argument(fmt::format("{}: {}", table_.source, why));
  }
  [[noreturn]] void refuse_line(const std::string& why) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", table_.source, line_, why));
  }

  void read_header(std::string_view line) {
    between_ = delimiter_of(line);
    bool numbers = true;
    for_cells(line, between_, [&](std::string_view cell) {
      double ignored = 0;
      numbers = numbers && read_number(cell, between_, ignored);
      table_.columns.push_back(named(cell));
    });
    if (numbers) {
      refuse_line("a line of names is wanted first, with units: \"angle [deg], lift [mm]\"");
    }
    if (table_.columns.size() < 2) {
      refuse_line(
          "there is one column; two at least are wanted, separated by commas, semicolons "
          "or tabs");
    }
  }

  void read_row(std::string_view line) {
    decimals_.resize(table_.columns.size());
    texts_.resize(table_.columns.size());
    std::size_t i = 0;
    for_cells(line, between_, [&](std::string_view cell) {
      if (i < table_.columns.size()) read_cell(cell, i);
      ++i;
    });
    if (i != table_.columns.size()) {
      refuse_line(fmt::format("{} cells, where the header has {}", i, table_.columns.size()));
    }
  }

  void read_cell(std::string_view cell, std::size_t i) {
    SampleColumn& column = table_.columns[i];
    double value = kNaN;
    const bool is_number = read_number(cell, between_, value);
    if ((!is_number || std::isinf(value)) && column.fault.empty()) {
      column.fault = fmt::format("{}:{}: '{}' is {}", table_.source, line_, cell.substr(0, 40),
                                 is_number ? "infinite" : "no number");
    }
    if (!is_number) ++texts_[i];
    column.values.push_back(is_number ? value : kNaN);
    // Of a zero nothing tells how many digits were meant.
    if (is_number && std::isfinite(value) && value != 0) decimals_[i].take(decimals_of(cell));
  }

  SampleTable table_;
  char between_ = ',';
  std::size_t line_ = 0;
  std::vector<Decimals> decimals_;
  std::vector<std::size_t> texts_;  ///< cells that are neither empty nor numbers
};

SampleTable read_from(std::istream& in, const std::string& source) {
  Reader reader(source);
  std::string line;
  bool is_first = true;
  while (std::getline(in, line)) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    const bool is_marked = is_first && line.starts_with(kByteOrderMark);
    reader.take(std::string_view(line).substr(is_marked ? kByteOrderMark.size() : 0));
    is_first = false;
  }
  return reader.ended();
}

}  // namespace

SampleTable numbers_of(const SampleTable& table,
                       std::initializer_list<const SampleColumn*> columns) {
  SampleTable result{.source = table.source, .columns = {}};
  for (const SampleColumn* column : columns) {
    check_name(table, column->name);
    if (!column->fault.empty()) throw std::invalid_argument(column->fault);
    result.columns.push_back({.name = column->name,
                              .unit = column->unit,
                              .values = {},
                              .last_digit = column->last_digit});
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool lacks = std::any_of(columns.begin(), columns.end(), [&](const SampleColumn* column) {
      return std::isnan(column->values[row]);
    });
    result.left_out += lacks ? 1 : 0;
    std::size_t i = 0;
    for (const SampleColumn* column : columns) {
      if (!lacks) result.columns[i++].values.push_back(column->values[row]);
    }
  }
  check_rows(result);
  return result;
}

SampleTable read_samples(const std::string& path) {
  if (path == "-") return read_from(std::cin, "standard input");
  if (std::filesystem::is_directory(path)) throw std::invalid_argument(path + ": it is a folder");
  std::ifstream file(path);
  if (!file) throw std::invalid_argument(path + ": it cannot be read");
  return read_from(file, path);
}

SampleTable parse_samples(const std::string& text, const std::string& source) {
  std::istringstream in(text);
  return read_from(in, source);
}

}  // namespace camlaw::problems
