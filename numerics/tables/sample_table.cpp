// SPDX-License-Identifier: MIT
#include "numerics/tables/sample_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "numerics/tables/cells.h"
#include "numerics/tables/line_source.h"
#include "numerics/tables/table_layout.h"
#include "numerics/text/csv_rows.h"
#include "numerics/text/file_text.h"

namespace camlaw::problems {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

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
  static constexpr int kMost = 30;  // decimals to either side: no measured value has more
  std::array<std::size_t, 2 * kMost + 1> counts_{};
};

/// Whether commas in a column's numbers part thousands ("25,000" beside "873") or may do so: each
/// has one to three digits before it, no leading zero, and three behind it, while other numbers are
/// whole and too small for one.
class Commas {
 public:
  void take(std::size_t line, std::string_view cell) {
    const std::size_t comma = cell.find(',');
    const std::string_view whole = digits_of(cell.substr(0, comma));
    const bool is_short = !whole.empty() && whole.size() <= 3 && whole.front() != '0' &&
                          whole.find_first_not_of(kDigits) == std::string_view::npos;
    if (comma == std::string_view::npos) {
      (is_short ? has_small_ : has_other_) = true;
      return;
    }
    const std::string_view behind = cell.substr(comma + 1);
    const bool parts = is_short && behind.size() == 3 &&
                       behind.find_first_not_of(kDigits) == std::string_view::npos;
    if (!parts) has_other_ = true;
    if (line_ == 0) line_ = line, first_ = std::string(cell);
  }
  /// What is wrong with the column then; empty where nothing is.
  std::string fault(const std::string& source) const {
    if (line_ == 0 || !has_small_ || has_other_) return "";
    return fmt::format(
        "{}:{}: the comma of '{}' may part thousands or stand for the decimal point, as other "
        "numbers of the column have none; write the numbers without thousands separators, or all "
        "with as many decimals",
        source, line_, first_);
  }

 private:
  static constexpr std::string_view kDigits = "0123456789";

  static std::string_view digits_of(std::string_view number) {
    const bool has_sign = !number.empty() && (number.front() == '-' || number.front() == '+');
    return has_sign ? number.substr(1) : number;
  }

  std::size_t line_ = 0;  ///< of the first comma
  std::string first_;
  bool has_small_ = false, has_other_ = false;
};

void check_rows(const SampleTable& table) {
  const std::size_t rows = table.rows();
  if (rows >= 2) return;
  throw std::invalid_argument(fmt::format("{}: it has {} row{} of numbers; at least two are needed",
                                          table.source, rows, rows == 1 ? "" : "s"));
}

void check_name(const SampleTable& table, const std::string& name) {
  if (name.empty()) {
    throw std::invalid_argument(fmt::format("{}: a column has no name", table.source));
  }
  const auto count = std::count_if(table.columns.begin(), table.columns.end(),
                                   [&](const SampleColumn& c) { return c.name == name; });
  if (count < 2) return;
  throw std::invalid_argument(fmt::format("{}: column '{}' appears twice", table.source, name));
}

class Reader {
 public:
  explicit Reader(std::string source) { table_.source = std::move(source); }

  void take(std::size_t number, const std::string& line) {
    if (trimmed_cell(line).empty()) return;
    if (is_laid_out_) return read_row(number, line);
    leading_.push_back({number, line});
    leading_bytes_ += line.size();
    if (!is_row_of_numbers(line)) {
      if (leading_.size() < kMostLeading && leading_bytes_ < kMostLeadingBytes) return;
    } else if (const auto layout = layout_above_last(leading_)) {
      return begin_with(*layout);
    } else if (++nameless_rows_ < kMostNamelessRows) {
      return;
    }
    begin_with(first_line_layout(leading_, table_.source));
  }

  SampleTable ended() {
    if (!is_laid_out_) begin_with(first_line_layout(leading_, table_.source));
    check_rows(table_);
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      SampleColumn& column = table_.columns[i];
      column.last_digit = decimals_[i].last_digit();
      if (column.fault.empty()) column.fault = commas_[i].fault(table_.source);
      const auto numbers = std::count_if(column.values.begin(), column.values.end(),
                                         [](double value) { return !std::isnan(value); });
      column.is_text = texts_[i] > static_cast<std::size_t>(numbers);
    }
    return std::move(table_);
  }

 private:
  // What may stand before the names, and how many rows of numbers without any are looked at.
  static constexpr std::size_t kMostLeading = 1000, kMostNamelessRows = 20;
  static constexpr std::size_t kMostLeadingBytes = std::size_t{1} << 22;

  [[noreturn]] void refuse_line(std::size_t number, const std::string& why) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", table_.source, number, why));
  }

  /// Takes the names and the rows that have been read so far.
  void begin_with(const TableLayout& layout) {
    if (layout.columns.size() > kMostColumns) {
      refuse_line(leading_.back().number, fmt::format("there are {} columns; {} at most are read",
                                                      layout.columns.size(), kMostColumns));
    }
    for (const ColumnName& column : layout.columns) {
      table_.columns.push_back({.name = column.name, .unit = column.unit, .values = {}});
    }
    decimals_.resize(table_.columns.size());
    commas_.resize(table_.columns.size());
    texts_.resize(table_.columns.size());
    between_ = layout.between;
    is_laid_out_ = true;
    for (std::size_t i = layout.first_row; i < leading_.size(); ++i) {
      read_row(leading_[i].number, leading_[i].text);
    }
    leading_.clear();
  }

  void read_row(std::size_t number, const std::string& line) {
    if (is_comment(trimmed_cell(line))) return;
    std::vector<std::string_view> cells = cells_of(line, between_);
    const std::size_t count = table_.columns.size();
    if (cells.size() == count + 1 && cells.back().empty()) cells.pop_back();
    if (cells.size() != count) {
      refuse_line(number, wrong_cells(cells.size(), count));
    }
    if ((table_.lines.size() + 1) * count > kMostCells) {
      refuse_line(
          number,
          fmt::format("the table has more than {} numbers; use fewer rows or columns", kMostCells));
    }
    for (std::size_t i = 0; i < count; ++i) read_cell(number, cells[i], i);
    table_.lines.push_back(static_cast<std::uint32_t>(number));
  }

  void read_cell(std::size_t number, std::string_view cell, std::size_t i) {
    SampleColumn& column = table_.columns[i];
    double value = kNaN;
    const bool is_number = read_number(cell, value);
    if ((!is_number || std::isinf(value)) && column.fault.empty()) {
      column.fault = fmt::format("{}:{}: '{}' is {}", table_.source, number, cell.substr(0, 40),
                                 is_number ? "infinite" : "not a number");
    }
    if (!is_number) ++texts_[i];
    column.values.push_back(is_number ? value : kNaN);
    // Of a zero nothing tells how many digits were meant.
    if (!is_number || !std::isfinite(value) || value == 0) return;
    decimals_[i].take(decimals_of(cell));
    commas_[i].take(number, cell);
  }

  SampleTable table_;
  std::vector<NumberedLine> leading_;  ///< until the names are found
  std::size_t leading_bytes_ = 0, nameless_rows_ = 0;
  bool is_laid_out_ = false;
  char between_ = ',';
  std::vector<Decimals> decimals_;
  std::vector<Commas> commas_;
  std::vector<std::size_t> texts_;  ///< cells that are neither empty nor numbers
};

SampleTable read_from(std::istream& in, const std::string& source) {
  Reader reader(source);
  LineSource lines(in, source);
  for (std::string line; lines.next(line);) reader.take(lines.number(), line);
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
    if (!lacks && !table.lines.empty()) result.lines.push_back(table.lines[row]);
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
  if (std::filesystem::is_directory(path))
    throw std::invalid_argument(path + ": it is a folder, not a table");
  errno = 0;
  std::ifstream file(path);
  if (!file) throw std::invalid_argument(path + ": " + problems::unreadable(errno));
  return read_from(file, path);
}

SampleTable parse_samples(const std::string& text, const std::string& source) {
  std::istringstream in(text);
  return read_from(in, source);
}

}  // namespace camlaw::problems
