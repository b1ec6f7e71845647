// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numerics/tables/column_names.h"
#include "numerics/tables/sample_table.h"

/// What the columns of measured tables are called, and what they are counted in.
namespace camlaw::problems {

/// The first column that is wanted, of several one that is not text; null where there is none.
const SampleColumn* first_column(const SampleTable& table,
                                 const std::function<bool(const SampleColumn&)>& is_wanted);
/// That which is named as one of a kind.
const SampleColumn* find_column(const SampleTable& table, ColumnKind kind);

/// That which is not the other one.
const SampleColumn& column_beside(const SampleTable& table, const SampleColumn* other);
/// The column of the place: named as an angle, a time or x, else the first but `value`, which may
/// be null.
const SampleColumn& place_column(const SampleTable& table, const SampleColumn* value);

/// Whether a column's unit is of a unit's kind.
bool has_kind(const SampleColumn& column, const std::string& unit);

/// Values and the unit that they are in.
struct UnitValues {
  std::vector<double> values;
  std::string unit;
  double factor = 1;  ///< from the column's own unit
};

/// A column's values in the first of `units` that is of its kind; "1" stands for plain numbers.
/// Throws std::invalid_argument naming table, column and the units that it may have.
UnitValues in_unit(const SampleTable& table, const SampleColumn& column,
                   const std::vector<std::string>& units);

/// What a column's values are rounded to, in its own unit: one in the last digit, or a step that
/// all are multiples of.
double resolution_of(const SampleColumn& column);

}  // namespace camlaw::problems
