// SPDX-License-Identifier: MIT
#include "fitting/motions/missing_marks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace camlaw::problems {
namespace {

/// A repeated value apart from the others, which reach from `low` to `high`.
struct Mark {
  double value, low, high;
  std::size_t count;
};

/// The lowest of sorted values if it is a mark, or with `sign` -1 the highest.
std::optional<Mark> mark_among(const std::vector<double>& sorted, double sign) {
  constexpr std::size_t kLeast = 3;  // one or two rows alike may be slips
  // A motion that is sampled within has no such gap between a rest and all that follows.
  constexpr double kFar = 1.5;
  const double value = sorted.front();
  const auto other = std::upper_bound(sorted.begin(), sorted.end(), value);
  const auto count = static_cast<std::size_t>(other - sorted.begin());
  if (count < kLeast || 2 * count > sorted.size()) return {};
  const double low = *other, high = sorted.back();
  if (!(high > low) || !(low - value > kFar * (high - low))) return {};
  return Mark{sign * value, std::min(sign * low, sign * high), std::max(sign * low, sign * high),
              count};
}

std::optional<Mark> mark_in(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  if (auto lowest = mark_among(values, 1)) return lowest;
  for (double& value : values) value = -value;
  std::reverse(values.begin(), values.end());
  return mark_among(values, -1);
}

}  // namespace

std::string marks_of_missing(const SampleColumn& column, const std::vector<std::uint32_t>& lines) {
  const auto mark = mark_in(column.values);
  if (!mark) return "";
  constexpr std::size_t kShown = 5;
  std::vector<std::uint32_t> where;
  for (std::size_t i = 0; i < lines.size() && where.size() < kShown; ++i) {
    if (column.values[i] == mark->value) where.push_back(lines[i]);
  }
  const std::string at = where.empty() ? ""
                                       : fmt::format(" (lines {}{})", fmt::join(where, ", "),
                                                     mark->count > where.size() ? ", ..." : "");
  return fmt::format(
      "{} rows of column '{}' hold exactly {:.6g}{}, far from all other values, {:.6g} to {:.6g}: "
      "it is probably a mark of missing values; leave these cells empty, or write NaN",
      mark->count, column.name, mark->value, at, mark->low, mark->high);
}

}  // namespace camlaw::problems
