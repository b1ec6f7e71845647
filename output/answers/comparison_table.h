// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/document/document.h"

/// A table with a column for each of several designs.
namespace camlaw::cli {

inline constexpr const char* kNoValue = "\u2013";

/// What one design has in a row, or nothing.
struct RowCell {
  std::string text = kNoValue;
  Json value = nullptr;
  std::optional<double> rank = {};  ///< of what may be the best of its row: more is better
};

/// A number without a rank; nothing for NaN.
RowCell row_number(double value);

/// The cells of a row. Where some that are ranked are better than others, the best has ", best"
/// behind it and is coloured.
std::vector<Cell> marked(const std::vector<RowCell>& row);

class ComparisonTable {
 public:
  /// `letters` are the designs', titles of their columns.
  ComparisonTable(std::string key, Column first, const std::vector<std::string>& letters,
                  bool with_unit);

  void add(const std::string& name, const std::string& unit, const std::vector<RowCell>& row);
  Table table() && { return std::move(table_); }

 private:
  Table table_;
  bool with_unit_;
};

/// Names with their units, each once, in the order in which they were taken.
using UnitNames = std::vector<std::pair<std::string, std::string>>;
void take_name(UnitNames& names, const std::string& name, const std::string& unit);

/// Names of one design, such as those of its limits.
struct OwnNames {
  std::string letter;
  std::vector<std::string> names;
};
/// "Only A and B have the limits x, y.", `what` being "limit", of names that not all designs have,
/// a sentence each.
std::vector<std::string> unshared_words(const std::vector<OwnNames>& all, const std::string& what);

}  // namespace camlaw::cli
