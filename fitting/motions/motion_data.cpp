// SPDX-License-Identifier: MIT
#include "fitting/motions/motion_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "fitting/motions/further_turns.h"
#include "fitting/motions/missing_marks.h"
#include "fitting/samples/condensed.h"
#include "numerics/tables/assumed_units.h"
#include "numerics/tables/columns.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

/// 0 displacement, 1 velocity, 2 acceleration; none for another name.
std::optional<int> order_of(const SampleColumn& column) {
  if (is_named(column.name, ColumnKind::Displacement)) return 0;
  if (is_named(column.name, ColumnKind::Velocity)) return 1;
  if (is_named(column.name, ColumnKind::Acceleration)) return 2;
  return {};
}

const SampleColumn& motion_column(const SampleTable& table) {
  const auto is_motion = [](const SampleColumn& column) { return order_of(column).has_value(); };
  if (const SampleColumn* named = first_column(table, is_motion)) return *named;
  return column_beside(table, &place_column(table, nullptr));
}

/// Of a column whose name says nothing of what it holds.
std::string taken_as(const SampleColumn& column, int order) {
  constexpr const char* kWhat[] = {"displacement", "velocity", "acceleration"};
  return fmt::format("column '{}' has no name of a quantity: read as the {}", column.name,
                     kWhat[order]);
}

/// Of angles that would be a whole turn if they were in radians.
std::optional<std::string> taken_as_plain(const SampleColumn& angle) {
  constexpr double kNearly = 0.9;  // of a turn: a record without its last step may be a whole one
  if (!angle.unit.empty() || !is_named(angle.name, ColumnKind::Angle)) return {};
  const auto [low, high] = std::minmax_element(angle.values.begin(), angle.values.end());
  if (angle.values.empty() || !(*high - *low > kNearly * kTurn)) return {};
  return fmt::format(
      "column '{}' states no unit and covers a turn of radians: read as plain numbers, which do "
      "not start again after a turn; write '{} [rad]'",
      angle.name, angle.name);
}

std::string divided(const std::string& unit, const std::string& by, int order) {
  if (order == 0) return unit;
  if (by == "1") return unit;
  return order == 1 ? fmt::format("{}/{}", unit, by) : fmt::format("{}/{}{}", unit, by, order);
}

}  // namespace

bool has_lift(const SampleTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [](const SampleColumn& column) { return order_of(column) == 0; });
}

MotionRecord motion_record(const SampleTable& table) {
  const SampleColumn& motion = motion_column(table);
  SampleTable own = numbers_of(table, {&place_column(table, &motion), &motion});
  MotionRecord record;
  const SampleColumn& value = own.columns[1];
  if (auto note = assume_degrees(own.columns[0])) {
    record.notes.push_back(std::move(*note));
  } else if (auto plain = taken_as_plain(own.columns[0])) {
    record.notes.push_back(std::move(*plain));
  }
  MotionSamples& samples = record.samples;
  samples.lacking = own.left_out;
  if (const std::string marks = marks_of_missing(value, own.lines); !marks.empty()) {
    throw std::invalid_argument(fmt::format("{}: {}", table.source, marks));
  }
  UnitValues places = in_unit(own, own.columns[0], {"deg", "s", "1"});
  const std::vector<std::string> lengths{"mm", "deg", "1"};
  const auto units_of = [&](int order) {
    std::vector<std::string> units;
    for (const std::string& length : lengths) units.push_back(divided(length, places.unit, order));
    return units;
  };
  const auto fits = [&](int order) {
    const auto units = units_of(order);
    return std::any_of(units.begin(), units.end(),
                       [&](const std::string& unit) { return has_kind(value, unit); });
  };
  if (const auto order = order_of(value)) {
    samples.order = *order;
  } else {  // its unit may tell
    if (!fits(0)) samples.order = fits(1) ? 1 : fits(2) ? 2 : 0;
    record.notes.push_back(taken_as(value, samples.order));
  }
  if (samples.order > 0 && places.unit == "1" && !fits(samples.order)) {
    const std::string& place = own.columns[0].name;
    throw std::invalid_argument(
        fmt::format("{}: column '{}' is in '{}', and column '{}' states no unit; write '{} [deg]' "
                    "or '{} [s]'",
                    table.source, value.name, value.unit, place, place, place));
  }
  const std::vector<std::string> units = units_of(samples.order);
  UnitValues values = in_unit(own, value, units);
  const auto which = std::find(units.begin(), units.end(), values.unit) - units.begin();
  samples.length_unit = lengths[static_cast<std::size_t>(which)];
  samples.resolution = std::abs(values.factor) * resolution_of(value);
  record.lines = std::move(own.lines);
  samples.place = std::move(places.values);
  samples.value = std::move(values.values);
  samples.place_unit = std::move(places.unit);
  samples.unit = std::move(values.unit);
  leave_out_stray_places(record);
  fold_further_turns(record);
  // A fit takes as long as there are samples; most records end with 10 000 means.
  constexpr std::size_t kMostMeans = 100000;
  Condensed means =
      condensed(std::move(samples.place), std::move(samples.value), samples.resolution, kMostMeans);
  samples.place = std::move(means.place);
  samples.value = std::move(means.value);
  samples.each = means.each;
  if (means.each > 1) record.lines.clear();
  // Where noise is larger than the rounding, means are rounded so much less.
  if (means.deviation > samples.resolution) {
    samples.resolution /= std::sqrt(static_cast<double>(means.each));
  }
  samples.left_out = means.left_out;
  return record;
}

MotionSamples motion_samples(const SampleTable& table) { return motion_record(table).samples; }

double cycle_period(const MotionSamples& samples) {
  constexpr double kWhole = 0.95;  // of a turn: a record with a row each 15 deg covers 345 deg
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  const bool is_turn = samples.place_unit == "deg" && *high - *low > kWhole * kTurnDegrees;
  return is_turn ? kTurnDegrees : 0;
}

Possible<FoundCycle> possible_motions(const MotionSamples& samples) {
  // Fewer samples leave a smoothing spline no freedom (bad_samples).
  constexpr std::size_t kEnough = 24;
  FoundCycle result;
  const auto [first, last] = std::minmax_element(samples.place.begin(), samples.place.end());
  const double range = *last - *first;
  const bool is_angle = samples.place_unit == "deg";
  if (is_angle && range > kLongestTurn) {
    return Impossible{
        fmt::format("the angles go over {:.6g} deg; give at most one turn of 360 deg", range)};
  }
  const double period = cycle_period(samples);
  if (samples.order != 0 || samples.place.size() < kEnough) {
    result.motions.push_back({guess_motion(samples), samples, period == 0, period == 0});
    return result;
  }
  SegmentOptions options;
  options.least_noise = rounding_deviation(samples);
  if (period > 0) options.period = period;
  auto found = possible_segments(samples.place, samples.value, options);
  if (!found) return found.reason();
  result.noise = found->noise;
  result.outlying = found->outlying.size();
  result.segments = std::move(found->segments);
  const auto& segments = result.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const FoundSegment& s = segments[i];
    if (s.kind == SegmentKind::Dwell) continue;
    const auto beside = [&](std::size_t k) {
      const FoundSegment& other = segments[k];
      return other.kind == SegmentKind::Dwell ? (other.end - other.begin) / 2 : 0.0;
    };
    const std::size_t count = segments.size();
    const bool is_only =
        std::count_if(segments.begin(), segments.end(),
                      [](const FoundSegment& one) { return one.kind != SegmentKind::Dwell; }) == 1;
    const bool has_before = i > 0 || period > 0, has_after = i + 1 < count || period > 0;
    if (is_only && period == 0) {  // all samples belong to it, far-off ones at its ends too
      result.motions.push_back({{s.begin, s.end, s.from, s.to}, samples, true, true});
      break;
    }
    const double low = s.begin - (has_before && count > 1 ? beside((i + count - 1) % count) : 0);
    const double high = s.end + (has_after && count > 1 ? beside((i + 1) % count) : 0);
    MotionSamples own = between(samples, low, high, period);
    if (own.place.size() < kFewestOfMotion) {  // a few rows that lie off are not a motion
      result.segments[i].kind = SegmentKind::Dwell;
      continue;
    }
    result.motions.push_back({{s.begin, s.end, s.from, s.to},
                              std::move(own),
                              period == 0 && i == 0,
                              period == 0 && i + 1 == count});
  }
  if (result.motions.empty()) return Impossible{"samples: they show no motion"};
  return result;
}

FoundCycle find_motions(const MotionSamples& samples) { return possible_motions(samples).value(); }

}  // namespace camlaw::problems
