// SPDX-License-Identifier: MIT
#include "problems/fits/sample_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/predicate.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
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

/// Calls take(cell) for each cell of a line.
template <class F>
void for_cells(std::string_view line, char between, F take) {
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(between, from), line.size());
    take(trimmed(line.substr(from, to - from)));
    from = to + 1;
  }
}

char delimiter_of(std::string_view header) {
  for (const char c : {';', '\t'}) {
    if (header.find(c) != std::string_view::npos) return c;
  }
  return ',';
}

/// "lift [mm]" or "lift (mm)".
SampleColumn named(std::string_view cell) {
  const std::size_t open = cell.find_first_of("[(");
  const std::size_t close = cell.find_last_of("])");
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
    return {std::string(cell), "", {}};
  }
  return {std::string(trimmed(cell.substr(0, open))),
          std::string(trimmed(cell.substr(open + 1, close - open - 1))),
          {}};
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
  /// One in the last digit that half of the cells have or go beyond.
  double last_digit() const {
    std::size_t all = 0, so_far = 0;
    for (const std::size_t count : counts_) all += count;
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
    if (table_.rows() < 2) {
      refuse(fmt::format("it has {} row{} of numbers; two at least are wanted", table_.rows(),
                         table_.rows() == 1 ? "" : "s"));
    }
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      table_.columns[i].last_digit = decimals_[i].last_digit();
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
    for (const SampleColumn& column : table_.columns) {
      const auto same = [&](const SampleColumn& c) { return c.name == column.name; };
      if (column.name.empty()) refuse_line("a column has no name");
      if (std::count_if(table_.columns.begin(), table_.columns.end(), same) > 1) {
        refuse_line(fmt::format("column '{}' is there twice", column.name));
      }
    }
  }

  void read_row(std::string_view line) {
    row_.clear(), places_.clear();
    decimals_.resize(table_.columns.size());
    for_cells(line, between_, [&](std::string_view cell) {
      double value = 0;
      if (!read_number(cell, between_, value)) {
        refuse_line(fmt::format("'{}' is no number", cell.substr(0, 40)));
      }
      if (std::isinf(value)) refuse_line(fmt::format("'{}' is infinite", cell));
      row_.push_back(value);
      places_.push_back(decimals_of(cell));
    });
    if (row_.size() != table_.columns.size()) {
      refuse_line(
          fmt::format("{} cells, where the header has {}", row_.size(), table_.columns.size()));
    }
    if (std::any_of(row_.begin(), row_.end(), [](double v) { return std::isnan(v); })) {
      ++table_.left_out;
      return;
    }
    for (std::size_t i = 0; i < row_.size(); ++i) table_.columns[i].values.push_back(row_[i]);
    for (std::size_t i = 0; i < row_.size(); ++i) decimals_[i].take(places_[i]);
  }

  SampleTable table_;
  char between_ = ',';
  std::size_t line_ = 0;
  std::vector<double> row_;
  std::vector<int> places_;
  std::vector<Decimals> decimals_;
};

SampleTable read_from(std::istream& in, const std::string& source) {
  Reader reader(source);
  std::string line;
  while (std::getline(in, line)) reader.take(line);
  return reader.ended();
}

}  // namespace

const SampleColumn& SampleTable::column(const std::string& name) const {
  std::vector<std::string> names;
  for (const SampleColumn& c : columns) {
    if (c.name == name) return c;
    names.push_back(c.name);
  }
  throw std::invalid_argument(
      fmt::format("{}: no column '{}'; there are {}", source, name, fmt::join(names, ", ")));
}

SampleTable read_samples(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::invalid_argument(path + ": it cannot be read");
  return read_from(file, path);
}

SampleTable parse_samples(const std::string& text, const std::string& source) {
  std::istringstream in(text);
  return read_from(in, source);
}

}  // namespace camlaw::problems
