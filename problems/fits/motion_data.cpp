// SPDX-License-Identifier: MIT
#include "problems/fits/motion_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "problems/units.h"

namespace camlaw::problems {
namespace {

constexpr double kTurn = 360;

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_one_of(const std::string& name, std::initializer_list<const char*> known) {
  const std::string plain = lower_case(name);
  return std::any_of(known.begin(), known.end(), [&](const char* k) { return plain == k; });
}

/// 0 displacement, 1 velocity, 2 acceleration; none for another name.
std::optional<int> order_of(const std::string& name) {
  if (is_one_of(name, {"lift", "displacement", "s", "y", "h"})) return 0;
  if (is_one_of(name, {"velocity", "v", "s'"})) return 1;
  if (is_one_of(name, {"acceleration", "a", "s''"})) return 2;
  return {};
}

/// The factor to the first of `targets` that is of the unit's kind, and that target.
std::pair<double, std::string> in_known_unit(const SampleColumn& column, const std::string& source,
                                             const std::vector<std::string>& targets) {
  for (const std::string& target : targets) {
    if (column.unit.empty() || column.unit == "1" || column.unit == "-") {
      if (target == "1") return {1, "1"};
      continue;
    }
    if (target == "1") continue;
    try {
      return {convert_unit(1, column.unit, target), target};
    } catch (const std::invalid_argument&) {  // of another kind
    }
  }
  throw std::invalid_argument(fmt::format(
      "{}: column '{}' is in '{}'; {} or a unit of the same kind is wanted", source, column.name,
      column.unit.empty() ? "no unit" : column.unit, fmt::join(targets, ", ")));
}

std::string divided(const std::string& unit, const std::string& by, int order) {
  if (order == 0) return unit;
  if (by == "1") return unit;
  return order == 1 ? fmt::format("{}/{}", unit, by) : fmt::format("{}/{}{}", unit, by, order);
}

void scale(std::vector<double>& values, double factor) {
  if (factor == 1) return;
  for (double& v : values) v *= factor;
}

}  // namespace

MotionSamples motion_samples(const SampleTable& table) {
  std::size_t place = 0;
  std::optional<std::size_t> value;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& name = table.columns[i].name;
    if (is_one_of(name, {"angle", "cam_angle", "phi", "theta", "x", "t", "time"})) place = i;
    if (!value && order_of(name)) value = i;
  }
  if (!value) value = place == 0 ? 1 : 0;
  const SampleColumn &at = table.columns[place], &of = table.columns[*value];
  MotionSamples samples;
  samples.order = order_of(of.name).value_or(0);
  const auto [place_factor, place_unit] = in_known_unit(at, table.source, {"deg", "s", "1"});
  std::vector<std::string> targets;
  for (const char* length : {"mm", "deg", "1"}) {
    targets.push_back(divided(length, place_unit, samples.order));
  }
  const auto [factor, unit] = in_known_unit(of, table.source, targets);
  samples.place = at.values;
  samples.value = of.values;
  samples.place_unit = place_unit;
  samples.unit = unit;
  scale(samples.place, place_factor);
  scale(samples.value, factor);
  return samples;
}

MotionSamples between(const MotionSamples& all, double low, double high, double period) {
  MotionSamples part;
  part.order = all.order;
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
