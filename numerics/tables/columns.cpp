// SPDX-License-Identifier: MIT
#include "numerics/tables/columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "numerics/text/unit_spelling.h"
#include "numerics/text/units.h"

namespace camlaw::problems {
namespace {

bool is_plain(const std::string& unit) { return unit.empty() || unit == "1" || unit == "-"; }

/// The factor from a column's unit to another; none where they are of different kinds.
std::optional<double> factor_to(const std::string& unit, const SampleColumn& column) {
  if (is_plain(column.unit) != (unit == "1")) return {};
  if (unit == "1") return 1;
  try {
    return unit_as_written(column.unit, unit);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

/// Whether values that are multiples of a step tell that they were rounded to it: slow places then
/// give one value more often than fast ones. Those of a straight line, up and down again, come
/// equally often each. Values are sorted.
bool are_rounded(const std::vector<double>& values, double step) {
  std::size_t least = values.size(), most = 0;
  std::size_t from = 0;
  for (std::size_t i = 1; i <= values.size(); ++i) {
    if (i < values.size() && values[i] - values[i - 1] < step / 2) continue;
    const bool is_outer = from == 0 || i == values.size();  // where the motion rests
    if (!is_outer) {
      least = std::min(least, i - from);
      most = std::max(most, i - from);
    }
    from = i;
  }
  return most >= least + 2;
}

/// The step that all values are multiples of, counted from the first: of an encoder that prints
/// more digits than it has. 0 where there is none.
double common_step(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double size = std::max(std::abs(values.front()), std::abs(values.back()));
  constexpr double kSame = 1e-12;
  double step = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double difference = values[i] - values[i - 1];
    if (difference > kSame * size && (step == 0 || difference < step)) step = difference;
  }
  if (step == 0) return 0;
  constexpr double kNear = 1e-3;
  for (const double value : values) {
    const double count = (value - values.front()) / step;
    if (std::abs(count - std::round(count)) > kNear) return 0;
  }
  return are_rounded(values, step) ? step : 0;
}

}  // namespace

const SampleColumn* first_column(const SampleTable& table,
                                 const std::function<bool(const SampleColumn&)>& is_wanted) {
  const SampleColumn* first = nullptr;
  for (const SampleColumn& column : table.columns) {
    if (!is_wanted(column)) continue;
    if (!column.is_text) return &column;
    if (first == nullptr) first = &column;
  }
  return first;
}

const SampleColumn* find_column(const SampleTable& table, ColumnKind kind) {
  return first_column(table, [&](const SampleColumn& c) { return is_named(c.name, kind); });
}

const SampleColumn& column_beside(const SampleTable& table, const SampleColumn* other) {
  return *first_column(table, [&](const SampleColumn& column) { return &column != other; });
}

const SampleColumn& place_column(const SampleTable& table, const SampleColumn* value) {
  const SampleColumn* place = first_column(table, [](const SampleColumn& column) {
    return is_named(column.name, ColumnKind::Angle) || is_named(column.name, ColumnKind::Time) ||
           is_named(column.name, ColumnKind::Across);
  });
  return place != nullptr && place != value ? *place : column_beside(table, value);
}

bool has_kind(const SampleColumn& column, const std::string& unit) {
  return factor_to(unit, column).has_value();
}

UnitValues in_unit(const SampleTable& table, const SampleColumn& column,
                   const std::vector<std::string>& units) {
  for (const std::string& unit : units) {
    const auto factor = factor_to(unit, column);
    if (!factor) continue;
    UnitValues result{column.values, unit, *factor};
    for (double& v : result.values) v *= *factor;
    return result;
  }
  if (const auto why = ambiguous(column.unit)) {
    throw std::invalid_argument(fmt::format("column {}: {}", column.name, *why));
  }
  throw std::invalid_argument(fmt::format(
      "{}: column '{}' is in '{}'; use {} or a unit of the same kind", table.source, column.name,
      column.unit.empty() ? "no unit" : column.unit, fmt::join(units, ", ")));
}

double resolution_of(const SampleColumn& column) {
  return std::max(column.last_digit, common_step(column.values));
}

}  // namespace camlaw::problems
