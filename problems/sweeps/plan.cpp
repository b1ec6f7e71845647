// SPDX-License-Identifier: MIT
#include "problems/sweeps/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>

#include "optim/problem/problem.h"
#include "problems/law_files/json_text.h"
#include "problems/statement/assignment.h"

namespace camlaw::problems {
namespace {

constexpr std::string_view kSweptExample = "speed=60:15:120 rpm";

/// The place of a cell along a curve of Hilbert (Skilling 2004), `digits` binary digits of each
/// number, the first of each number before the second of any.
std::vector<bool> along_curve(std::vector<std::uint32_t> cell, int digits) {
  const std::size_t n = cell.size();
  const std::uint32_t top = std::uint32_t{1} << (digits - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    for (std::size_t i = 0; i < n; ++i) {
      if ((cell[i] & q) != 0) {
        cell[0] ^= q - 1;
      } else {
        const std::uint32_t swapped = (cell[0] ^ cell[i]) & (q - 1);
        cell[0] ^= swapped;
        cell[i] ^= swapped;
      }
    }
  }
  for (std::size_t i = 1; i < n; ++i) cell[i] ^= cell[i - 1];
  std::uint32_t turned = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1) {
    if ((cell[n - 1] & q) != 0) turned ^= q - 1;
  }
  std::vector<bool> place;
  for (std::uint32_t& number : cell) number ^= turned;
  for (int digit = digits; digit-- > 0;) {
    for (const std::uint32_t number : cell) place.push_back(((number >> digit) & 1U) != 0);
  }
  return place;
}

/// Samples along a curve that fills the ranges, so that neighbours in order are near one another:
/// n log n, where always the nearest that is left takes n^2.
std::vector<std::size_t> in_near_order(const std::vector<std::vector<double>>& samples,
                                       const std::vector<SampledRange>& over) {
  // Bits of each number: samples that share a cell are near each other in any order.
  constexpr int kDigits = 16;
  constexpr double kMost = (1 << kDigits) - 1;
  std::vector<std::vector<bool>> places;
  for (const std::vector<double>& sample : samples) {
    std::vector<std::uint32_t> cell;
    for (std::size_t k = 0; k < over.size(); ++k) {
      const double part = (sample[k] - over[k].low) / (over[k].high - over[k].low);
      cell.push_back(static_cast<std::uint32_t>(std::clamp(part, 0.0, 1.0) * kMost));
    }
    places.push_back(along_curve(std::move(cell), kDigits));
  }
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return places[a] != places[b] ? places[a] < places[b] : a < b;
  });
  return order;
}

/// "ranges.speed" of "ranges.speed.upper", "cases.fast" of "cases.fast.speed"; empty where the name
/// is of no such table.
std::string_view table_of(std::string_view name) {
  for (const std::string_view table : {"ranges.", "variation.", "cases."}) {
    if (!name.starts_with(table)) continue;
    // Parameters of cams on a shaft have a dot in their names, load cases have none.
    const std::size_t end = table == "cases." ? name.find('.', table.size()) : name.rfind('.');
    return end < table.size() ? std::string_view() : name.substr(0, end);
  }
  return {};
}

template <class Value>
Value get(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) {
    throw std::invalid_argument(fmt::format("the study's setting 'sweep' lacks '{}'", key));
  }
  try {
    return found->get<Value>();
  } catch (const Json::exception&) {
    throw std::invalid_argument(fmt::format("the study's setting 'sweep' has a damaged '{}'", key));
  }
}

}  // namespace

void add_settings(SweepSettings& settings, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    if (auto axis = parse_axis(assignment)) {
      settings.axes.push_back(std::move(*axis));
    } else {
      settings.set.push_back(assignment);
      settings.fixed.push_back(assignment);
    }
  }
}

void SweepPlan::take_units(const std::function<std::string(const std::string& name)>& unit_of) {
  for (SweptName& name : names_) {
    if (name.is_numeric && name.unit.empty()) name.unit = unit_of(name.name);
  }
}

void check_set_or_swept(const SweepSettings& settings,
                        const std::vector<std::string>& assignments) {
  const auto is_swept = [&](std::string_view name) {
    const auto has_name = [&](const auto& swept) { return swept.name == name; };
    return std::any_of(settings.axes.begin(), settings.axes.end(), has_name) ||
           (settings.sampling &&
            std::any_of(settings.sampling->over.begin(), settings.sampling->over.end(), has_name));
  };
  for (const std::string& assignment : assignments) {
    const std::string_view name = parse_assignment(assignment, kSweptExample).name;
    if (parse_axis(assignment) || !is_swept(name)) continue;
    throw std::invalid_argument(
        fmt::format("{} is set to one value and swept; leave out one of the two", name));
  }
}

Sampling stated_sampling(const std::string& sample, std::uint64_t seed,
                         const std::vector<std::string>& over) {
  Sampling sampling = parse_sampling(sample, seed);
  for (const std::string& range : over) sampling.over.push_back(parse_sampled_range(range));
  return sampling;
}

SweepPlan::SweepPlan(SweepSettings settings) : settings_(std::move(settings)) {
  for (const SweepAxis& axis : settings_.axes) {
    names_.push_back({axis.name, axis.unit, axis.is_numeric()});
    size_ *= axis.values.size();
    if (size_ > kMostSwept) break;
  }
  if (settings_.sampling) {
    if (settings_.sampling->over.empty()) {
      throw std::invalid_argument(
          "--sample: no range is given to draw from; write --over 'base_radius=30:60 mm'");
    }
    for (const SampledRange& range : settings_.sampling->over) {
      names_.push_back({range.name, range.unit, true});
    }
    size_ *= settings_.sampling->count;
  }
  if (size_ > kMostSwept) {
    throw std::invalid_argument(fmt::format("the sweep has more than {} combinations", kMostSwept));
  }
  if (names_.empty()) {
    if (!settings_.set.empty()) {
      throw std::invalid_argument(fmt::format(
          "nothing is swept: {} has one value, which is the same in all; write several, such as "
          "--set 'speed=60:15:120 rpm' or --set 'law=cycloidal,modified-sine'",
          settings_.set.back()));
    }
    throw std::invalid_argument(
        "nothing is swept; write --set 'speed=60:15:120 rpm' or --set 'law=cycloidal,"
        "modified-sine', or --sample with --over");
  }
  std::set<std::string> seen;
  for (const SweptName& name : names_) {
    if (seen.insert(name.name).second) continue;
    throw std::invalid_argument(fmt::format("{} is swept twice", name.name));
  }
  if (settings_.sampling) samples_ = samples_of(*settings_.sampling);
  const auto is_of_swept_table = [&](const std::string& assignment) {
    const std::string_view table = table_of(parse_assignment(assignment, kSweptExample).name);
    return !table.empty() && std::any_of(names_.begin(), names_.end(), [&](const SweptName& swept) {
      return table_of(swept.name) == table;
    });
  };
  const auto first = std::stable_partition(settings_.set.begin(), settings_.set.end(),
                                           std::not_fn(is_of_swept_table));
  settings_.together.insert(settings_.together.end(), first, settings_.set.end());
  settings_.set.erase(first, settings_.set.end());
}

std::vector<SweptValue> SweepPlan::values(std::size_t combination) const {
  std::vector<SweptValue> result(settings_.axes.size());
  const std::size_t sample = combination % samples();
  combination /= samples();
  for (std::size_t k = settings_.axes.size(); k-- > 0;) {
    const SweepAxis& axis = settings_.axes[k];
    const std::size_t i = combination % axis.values.size();
    combination /= axis.values.size();
    result[k] = {axis.values[i], axis.is_numeric() ? axis.numbers[i] : 0, i};
  }
  for (std::size_t k = settings_.axes.size(); k < names_.size(); ++k) {
    const double number = samples_[sample][k - settings_.axes.size()];
    result.push_back({swept_value(number, names_[k].unit), number, sample});
  }
  return result;
}

std::vector<std::string> SweepPlan::assignments(std::size_t combination) const {
  std::vector<std::string> all = settings_.together;
  const std::vector<SweptValue> own = values(combination);
  for (std::size_t k = 0; k < own.size(); ++k) {
    all.push_back(fmt::format("{}={}", names_[k].name, own[k].text));
  }
  return all;
}

std::optional<std::size_t> SweepPlan::chained_axis() const {
  std::optional<std::size_t> longest;
  for (std::size_t k = 0; k < settings_.axes.size(); ++k) {
    const SweepAxis& axis = settings_.axes[k];
    if (!axis.is_numeric() || axis.values.size() < 2) continue;
    if (!longest || axis.values.size() >= settings_.axes[*longest].values.size()) longest = k;
  }
  return longest;
}

/// All combinations, those that differ in the chained number alone side by side.
std::vector<std::size_t> SweepPlan::in_sequence() const {
  std::vector<std::size_t> all;
  all.reserve(size_);
  if (settings_.sampling) {
    const std::vector<std::size_t> order = in_near_order(samples_, settings_.sampling->over);
    for (std::size_t first = 0; first < size_; first += samples()) {
      for (const std::size_t sample : order) all.push_back(first + sample);
    }
    return all;
  }
  std::size_t step = 1;
  const std::size_t axis = *chained_axis(), count = settings_.axes[axis].values.size();
  for (std::size_t k = axis + 1; k < settings_.axes.size(); ++k) {
    step *= settings_.axes[k].values.size();
  }
  for (std::size_t outer = 0; outer < size_; outer += step * count) {
    for (std::size_t inner = 0; inner < step; ++inner) {
      for (std::size_t i = 0; i < count; ++i) all.push_back(outer + inner + i * step);
    }
  }
  return all;
}

std::vector<std::vector<std::size_t>> SweepPlan::chains() const {
  std::vector<std::vector<std::size_t>> result;
  const bool joins = !settings_.is_cold && !settings_.evaluates;
  if (!joins || (!settings_.sampling && !chained_axis())) {
    for (std::size_t i = 0; i < size_; ++i) result.push_back({i});
    return result;
  }
  const std::vector<std::size_t> all = in_sequence();
  const std::size_t row =
      settings_.sampling ? samples() : settings_.axes[*chained_axis()].values.size();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % row % kChain == 0) result.emplace_back();
    result.back().push_back(all[i]);
  }
  return result;
}

Json to_json(const SweepSettings& settings) {
  Json axes = Json::array();
  for (const SweepAxis& axis : settings.axes) {
    axes.push_back({{"name", axis.name},
                    {"unit", axis.unit},
                    {"values", axis.values},
                    {"numbers", axis.numbers},
                    {"class", axis.is_class}});
  }
  Json result{{"axes", axes}, {"evaluate", settings.evaluates}, {"cold", settings.is_cold}};
  if (!settings.fixed.empty()) result["fixed"] = settings.fixed;
  if (!settings.together.empty()) result["together"] = settings.together;
  if (const auto& sampling = settings.sampling) {
    Json over = Json::array();
    for (const SampledRange& range : sampling->over) {
      over.push_back(
          {{"name", range.name}, {"unit", range.unit}, {"low", range.low}, {"high", range.high}});
    }
    result["sample"] = {{"method", to_string(sampling->method)},
                        {"count", sampling->count},
                        {"seed", sampling->seed},
                        {"over", over}};
  }
  return result;
}

SweepSettings sweep_settings(const Json& record, std::vector<std::string> set) {
  SweepSettings result{.set = std::move(set)};
  for (const Json& axis : get<Json>(record, "axes")) {
    result.axes.push_back({get<std::string>(axis, "name"), get<std::string>(axis, "unit"),
                           get<std::vector<std::string>>(axis, "values"),
                           get<std::vector<double>>(axis, "numbers"), get<bool>(axis, "class")});
    const SweepAxis& read = result.axes.back();
    const bool fits = read.numbers.empty() || read.numbers.size() == read.values.size();
    if (read.values.empty() || !fits) {
      throw std::invalid_argument("the study's setting 'sweep' has a damaged axis");
    }
  }
  result.evaluates = get<bool>(record, "evaluate");
  result.is_cold = get<bool>(record, "cold");
  if (record.contains("fixed")) result.fixed = get<std::vector<std::string>>(record, "fixed");
  if (record.contains("together")) {
    result.together = get<std::vector<std::string>>(record, "together");
  }
  if (!record.contains("sample")) return result;
  const Json sample = record["sample"];
  Sampling sampling = parse_sampling(
      fmt::format("{} {}", get<std::string>(sample, "method"), get<std::size_t>(sample, "count")),
      get<std::uint64_t>(sample, "seed"));
  for (const Json& range : get<Json>(sample, "over")) {
    sampling.over.push_back({get<std::string>(range, "name"), get<std::string>(range, "unit"),
                             get<double>(range, "low"), get<double>(range, "high")});
  }
  result.sampling = std::move(sampling);
  return result;
}

}  // namespace camlaw::problems
