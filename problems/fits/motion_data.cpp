// SPDX-License-Identifier: MIT
#include "problems/fits/motion_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "problems/fits/columns.h"
#include "problems/fits/condensed.h"

namespace camlaw::problems {
namespace {

constexpr double kTurn = 360;

/// 0 displacement, 1 velocity, 2 acceleration; none for another name.
std::optional<int> order_of(const SampleColumn& column) {
  if (is_called(column, {"lift", "displacement", "s", "y", "h"})) return 0;
  if (is_called(column, {"velocity", "v", "s'"})) return 1;
  if (is_called(column, {"acceleration", "a", "s''"})) return 2;
  return {};
}

std::string divided(const std::string& unit, const std::string& by, int order) {
  if (order == 0) return unit;
  if (by == "1") return unit;
  return order == 1 ? fmt::format("{}/{}", unit, by) : fmt::format("{}/{}{}", unit, by, order);
}

}  // namespace

MotionSamples motion_samples(const SampleTable& table) {
  const SampleColumn* place =
      find_column(table, {"angle", "cam_angle", "phi", "theta", "x", "t", "time"});
  if (place == nullptr) place = &table.columns.front();
  const SampleColumn* value = nullptr;
  for (const SampleColumn& column : table.columns) {
    if (value == nullptr && order_of(column)) value = &column;
  }
  if (value == nullptr) value = &table.columns[place == &table.columns.front() ? 1 : 0];
  MotionSamples samples;
  samples.order = order_of(*value).value_or(0);
  UnitValues places = in_unit(table, *place, {"deg", "s", "1"});
  std::vector<std::string> units;
  for (const char* length : {"mm", "deg", "1"}) {
    units.push_back(divided(length, places.unit, samples.order));
  }
  UnitValues values = in_unit(table, *value, units);
  Condensed means = condensed(std::move(places.values), std::move(values.values));
  samples.place = std::move(means.place);
  samples.value = std::move(means.value);
  samples.each = means.each;
  samples.left_out = means.left_out;
  samples.place_unit = std::move(places.unit);
  samples.unit = std::move(values.unit);
  return samples;
}

MotionSamples between(const MotionSamples& all, double low, double high, double period) {
  MotionSamples part;
  part.order = all.order;
  part.each = all.each;
  part.place_unit = all.place_unit;
  part.unit = all.unit;
  for (std::size_t i = 0; i < all.place.size(); ++i) {
    double place = all.place[i];
    if (period > 0) place = low + std::fmod(std::fmod(place - low, period) + period, period);
    if (place < low || place > high) continue;
    part.place.push_back(place);
    part.value.push_back(all.value[i]);
  }
  return part;
}

FoundCycle find_motions(const MotionSamples& samples) {
  constexpr std::size_t kEnough = 24;
  FoundCycle result;
  const auto [first, last] = std::minmax_element(samples.place.begin(), samples.place.end());
  const double range = *last - *first;
  const bool is_angle = samples.place_unit == "deg";
  constexpr double kWhole = 0.95;
  if (is_angle && range > kTurn * (1 + 1e-6)) {
    throw std::invalid_argument(
        fmt::format("the angles go over {:.6g} deg; one turn of 360 deg at most is wanted", range));
  }
  if (samples.order != 0 || samples.place.size() < kEnough) {
    result.motions.push_back({guess_motion(samples), samples});
    return result;
  }
  SegmentOptions options;
  const double period = is_angle && range > kWhole * kTurn ? kTurn : 0;
  if (period > 0) options.period = period;
  FoundSegments found = motion_segments(samples.place, samples.value, options);
  result.noise = found.noise;
  result.outlying = found.outlying.size();
  result.segments = std::move(found.segments);
  const auto& segments = result.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const FoundSegment& s = segments[i];
    if (s.kind == SegmentKind::Dwell) continue;
    const auto beside = [&](std::size_t k) {
      const FoundSegment& other = segments[k];
      return other.kind == SegmentKind::Dwell ? (other.end - other.begin) / 2 : 0.0;
    };
    const std::size_t count = segments.size();
    const bool has_before = i > 0 || period > 0, has_after = i + 1 < count || period > 0;
    if (count == 1 && period == 0) {  // all samples belong to it, far-off ones at its ends too
      result.motions.push_back({{s.begin, s.end, s.from, s.to}, samples});
      break;
    }
    const double low = s.begin - (has_before && count > 1 ? beside((i + count - 1) % count) : 0);
    const double high = s.end + (has_after && count > 1 ? beside((i + 1) % count) : 0);
    result.motions.push_back({{s.begin, s.end, s.from, s.to}, between(samples, low, high, period)});
  }
  if (result.motions.empty()) throw std::invalid_argument("samples: they show no motion");
  return result;
}

}  // namespace camlaw::problems
