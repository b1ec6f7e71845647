// SPDX-License-Identifier: MIT
#include "problems/fits/columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <stdexcept>

#include "problems/units.h"

namespace camlaw::problems {
namespace {

bool is_plain(const std::string& unit) { return unit.empty() || unit == "1" || unit == "-"; }

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

}  // namespace

bool is_called(const SampleColumn& column, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) {
    return boost::algorithm::iequals(column.name, name);
  });
}

const SampleColumn* find_column(const SampleTable& table,
                                std::initializer_list<const char*> names) {
  for (const SampleColumn& column : table.columns) {
    if (is_called(column, names)) return &column;
  }
  return nullptr;
}

UnitValues in_unit(const SampleTable& table, const SampleColumn& column,
                   const std::vector<std::string>& units) {
  for (const std::string& unit : units) {
    if (is_plain(column.unit) != (unit == "1")) continue;
    if (unit == "1") return {column.values, unit};
    try {
      return {times(column.values, convert_unit(1, column.unit, unit)), unit};
    } catch (const std::invalid_argument&) {  // of another kind
    }
  }
  throw std::invalid_argument(fmt::format(
      "{}: column '{}' is in '{}'; {} or a unit of the same kind is wanted", table.source,
      column.name, column.unit.empty() ? "no unit" : column.unit, fmt::join(units, ", ")));
}

}  // namespace camlaw::problems
