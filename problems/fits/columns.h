// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "problems/fits/sample_table.h"

/// What the columns of measured tables are called, and what they are counted in.
namespace camlaw::problems {

/// Whether a column has one of the names, in any case.
bool is_called(const SampleColumn& column, std::initializer_list<const char*> names);
/// The first column that has one of the names; null where there is none.
const SampleColumn* find_column(const SampleTable& table, std::initializer_list<const char*> names);

/// The column of the place: called angle, cam_angle, phi, theta, x, t or time, else the first that
/// is not `value`.
const SampleColumn& place_column(const SampleTable& table, const SampleColumn& value);

/// Values and the unit that they are in.
struct UnitValues {
  std::vector<double> values;
  std::string unit;
  /// What values are rounded to: one in the last digit, or a step that all are multiples of.
  double resolution = 0;
};

/// A column's values in the first of `units` that is of its kind; "1" stands for plain numbers.
/// Throws std::invalid_argument naming table, column and the units that it may have.
UnitValues in_unit(const SampleTable& table, const SampleColumn& column,
                   const std::vector<std::string>& units);

}  // namespace camlaw::problems
