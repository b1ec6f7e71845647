// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The tables of our own that the program carries. (What people measure is read more leniently:
/// numerics/tables/sample_table.h.)
namespace camlaw::problems {

struct CsvRow {
  std::size_t line;                ///< from 1
  std::vector<std::string> cells;  ///< of the wanted columns, in their order
};

/// Rows of a text with a line of names, cells separated by commas; a cell in quotes may hold
/// commas, and quotes as two in a row. Other columns are passed over. Throws std::invalid_argument,
/// "line 3: ...": a column that is missing, a row of another length, a quote that does not end.
std::vector<CsvRow> csv_rows(std::string_view text, const std::vector<std::string>& columns);

/// "1 cell, where the header has 2".
std::string wrong_cells(std::size_t count, std::size_t wanted);

}  // namespace camlaw::problems
