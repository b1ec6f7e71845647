// SPDX-License-Identifier: MIT
#include "numerics/tables/assumed_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/tables/columns.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

std::string assumed(const SampleColumn& column, const char* unit) {
  return fmt::format("column '{}' states no unit: read as {}", column.name, unit);
}

SampleColumn* own(SampleTable& table, const SampleColumn* found) {
  return found == nullptr ? nullptr
                          : &table.columns[static_cast<std::size_t>(found - table.columns.data())];
}

/// The greatest less the least of its numbers.
double range_of(const SampleColumn& column) {
  double low = INFINITY, high = -INFINITY;
  for (const double v : column.values) {
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  }
  return high - low;
}

}  // namespace

std::optional<std::string> assume_degrees(SampleColumn& column) {
  // A turn, and a little more where a record goes beyond it.
  constexpr double kMostRadians = 1.05 * kTurn;
  if (!column.unit.empty() || !is_named(column.name, ColumnKind::Angle)) return {};
  if (!(range_of(column) > kMostRadians)) return {};
  column.unit = "deg";
  return assumed(column, "deg");
}

std::vector<std::string> assume_profile_units(SampleTable& table) {
  std::vector<std::string> notes;
  const auto as_length = [&](SampleColumn* column) {
    if (column == nullptr || !column->unit.empty()) return;
    column->unit = "mm";
    notes.push_back(assumed(*column, "mm"));
  };
  SampleColumn* radius = own(table, find_column(table, ColumnKind::Radius));
  if (radius == nullptr) {
    as_length(own(table, find_column(table, ColumnKind::ProfileX)));
    as_length(own(table, find_column(table, ColumnKind::ProfileY)));
    return notes;
  }
  as_length(radius);
  SampleColumn* angle = own(table, find_column(table, ColumnKind::Angle));
  if (angle == nullptr || !angle->unit.empty()) return notes;
  if (auto note = assume_degrees(*angle)) {
    notes.push_back(std::move(*note));
    return notes;
  }
  throw std::invalid_argument(fmt::format(
      "{}: column '{}' states no unit and may be in deg or rad; write '{} [deg]' or '{} [rad]'",
      table.source, angle->name, angle->name, angle->name));
}

bool goes_round(const SampleTable& table) {
  const SampleColumn* x = find_column(table, ColumnKind::ProfileX);
  const SampleColumn* y = find_column(table, ColumnKind::ProfileY);
  if (x == nullptr || y == nullptr || !x->unit.empty() || !y->unit.empty()) return false;
  double turned = 0, before = NAN;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double angle = std::atan2(y->values[i], x->values[i]);
    if (std::isnan(angle)) continue;
    if (!std::isnan(before)) turned += std::remainder(angle - before, kTurn);
    before = angle;
  }
  // The record may end a step or some outliers short of where it began.
  constexpr double kNearlyRound = 0.9;
  return std::abs(turned) > kNearlyRound * kTurn;
}

}  // namespace camlaw::problems
