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

/// A step between sorted values that are written with a last digit, roughly: the mean of the
/// differences that are one step, which the last digit makes smaller or larger. 0 where all are
/// equal.
double rough_step(const std::vector<double>& values, double last_digit) {
  const double size = std::max(std::abs(values.front()), std::abs(values.back()));
  constexpr double kSame = 1e-12;  // of the largest: repeated values differ by rounding
  std::vector<double> differences;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double difference = values[i] - values[i - 1];
    if (difference > kSame * size) differences.push_back(difference);
  }
  if (differences.empty()) return 0;
  const double least = *std::min_element(differences.begin(), differences.end());
  const double most = std::min(1.5 * least, least + 2 * last_digit) + kSame * size;
  double sum = 0, count = 0;
  for (const double difference : differences) {
    if (difference <= most) sum += difference, ++count;
  }
  return sum / count;
}

/// How many steps each of the sorted values is from the first; the step becomes more certain the
/// more steps are counted.
std::vector<double> counted_steps(const std::vector<double>& values, double step) {
  // A first step may be off by its last digit, over eight by an eighth of it.
  constexpr double kMany = 8;
  std::vector<double> counts{0};
  for (std::size_t i = 1; i < values.size(); ++i) {
    counts.push_back(counts.back() + std::round((values[i] - values[i - 1]) / step));
    if (counts.back() >= kMany) step = (values[i] - values.front()) / counts.back();
  }
  return counts;
}

/// y = begin + slope x, by least squares.
struct StraightLine {
  double begin, slope;
};

StraightLine line_through(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return {mean_y - xy / xx * mean_x, xy / xx};
}

/// The step that all values are multiples of, counted from one of them, as far as their last digit
/// tells: of an encoder that prints more digits than it has, or of values that were converted from
/// another unit after they had been rounded. 0 where there is none.
double common_step(std::vector<double> values, double last_digit) {
  std::sort(values.begin(), values.end());
  const double rough = rough_step(values, last_digit);
  constexpr double kClear = 2.5;  // last digits: a smaller step is not told from them
  if (rough == 0 || rough < kClear * last_digit) return 0;
  const std::vector<double> counts = counted_steps(values, rough);
  if (counts.back() < 1) return 0;
  const auto [begin, step] = line_through(counts, values);
  // Half a last digit is a value's own rounding, and half as much the line's; an encoder's steps
  // are even to a thousandth.
  constexpr double kNear = 1e-3, kOfDigit = 0.75;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double off = std::abs(values[i] - begin - step * counts[i]);
    if (off > kNear * step + kOfDigit * last_digit) return 0;
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
  return std::max(column.last_digit, common_step(column.values, column.last_digit));
}

}  // namespace camlaw::problems
