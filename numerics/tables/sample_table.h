// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

/// Measured tables as people have them.
namespace camlaw::problems {

struct SampleColumn {
  std::string name, unit;      ///< as the header has them; unit "" where none is stated
  std::vector<double> values;  ///< NaN where a row has no number
  /// One in the last digit that most cells have.
  double last_digit = 0;
  /// Where a cell is neither empty nor a finite number, "t.csv:3: 'four' is not a number"; empty
  /// where none is.
  std::string fault = {};
  bool is_text = false;  ///< more cells hold something else than a number
};

struct SampleTable {
  std::string source;
  std::vector<SampleColumn> columns;
  std::vector<std::uint32_t> lines = {};  ///< of the file, that the rows stand on, from 1
  std::size_t left_out = 0;               ///< rows that numbers_of() has left out

  std::size_t rows() const { return columns.front().values.size(); }
};

/// More numbers than this are not read.
inline constexpr std::size_t kMostCells = 20'000'000;
inline constexpr std::size_t kMostColumns = 1000;

/// Reads a table with a line of names, each with its unit in brackets or parentheses:
/// "angle [deg], lift [mm]", or a line of units below. Cells are separated by commas, semicolons,
/// tabs or blanks; beside others than commas, and in quotes, numbers may have a decimal comma.
/// Lines above the names are passed over, and empty lines and those that begin with #. How names,
/// units and separators are found: numerics/tables/table_layout.h; encodings and line ends:
/// numerics/tables/line_source.h. Throws std::invalid_argument naming file and line: no header, too
/// few columns or rows, a row of another length, more than kMostCells or kMostColumns.
SampleTable read_samples(const std::string& path);
/// The same of a text; `source` names it in errors.
SampleTable parse_samples(const std::string& text, const std::string& source);

/// These columns of a table, in this order; rows in which one of them lacks a number are left out
/// and counted. Throws std::invalid_argument: a cell of theirs that is not a number, fewer than two
/// rows, a column without a name or one of a name that is there twice.
SampleTable numbers_of(const SampleTable& table,
                       std::initializer_list<const SampleColumn*> columns);

}  // namespace camlaw::problems
