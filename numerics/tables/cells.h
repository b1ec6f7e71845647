// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Cells of a line of a table.
namespace camlaw::problems {

/// What separates cells: a comma, a semicolon, a tab, or kBlanks.
inline constexpr char kBlanks = ' ';  ///< any number of blanks and tabs

/// Without blanks and quotes around it.
std::string_view trimmed_cell(std::string_view text);

/// A line's cells, trimmed. A separator in quotes separates nothing.
std::vector<std::string_view> cells_of(std::string_view line, char between);

/// Whether a cell says that it is not a number: it is empty, a dash, "nan", "n/a", "null" and the
/// like, or what a spreadsheet writes for an error ("#N/A", "#NV", "#VALUE!", "#DIV/0!").
bool is_missing(std::string_view cell);

/// A number, with a decimal point or a decimal comma; NaN for a cell that is_missing(). Whether the
/// cell is one of these.
bool read_number(std::string_view cell, double& value);

/// How many digits after the point a number is written with; below 0 of 1e3.
int decimals_of(std::string_view cell);

}  // namespace camlaw::problems
