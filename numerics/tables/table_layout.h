// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How a table is written: where its names stand, what separates its cells.
namespace camlaw::problems {

/// A line and its place in the file, from 1.
struct NumberedLine {
  std::size_t number;
  std::string text;
};

struct ColumnName {
  std::string name, unit;  ///< unit "" where none is stated
};

struct TableLayout {
  char between = ',';  ///< as cells_of takes it
  std::vector<ColumnName> columns;
  std::size_t first_row = 0;  ///< of the lines given, the first below the names
};

/// "lift [mm]", "lift (mm)", "lift in mm", "lift/mm" or "lift_mm"; any quantity and unit likewise.
/// A name of a known quantity keeps what stands for a unit after "in" or a slash, be it one or not.
ColumnName column_name(std::string_view cell);

/// Whether a line, trimmed, is none of the table: it begins with # or %.
bool is_comment(std::string_view line);

/// Whether a line has two numbers at least, however its cells are separated.
bool is_row_of_numbers(std::string_view line);

/// The layout by which the last line is the first row of numbers: the names are the nearest line
/// above that has as many cells, below it a line of units may stand; what stands above is passed
/// over. Names may stand in a comment (#) where no other line has them. None where no line above
/// can be the names.
std::optional<TableLayout> layout_above_last(const std::vector<NumberedLine>& lines);

/// Where no line has a layout above it: the first line's cells as names. Throws
/// std::invalid_argument that says what the lines lack.
TableLayout first_line_layout(const std::vector<NumberedLine>& lines, const std::string& source);

}  // namespace camlaw::problems
