// SPDX-License-Identifier: MIT
#include "fitting/samples/condensed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "numerics/linear/statistics.h"

namespace camlaw::problems {
namespace {

/// Neighbours that are taken as one.
struct Group {
  std::vector<double> place, value;
  double middle = 0, deviation = 0;  ///< by the median
};

std::vector<Group> groups_of(const std::vector<double>& place, const std::vector<double>& value,
                             std::size_t each) {
  std::vector<std::uint32_t> order(place.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return place[a] < place[b]; });
  std::vector<Group> groups;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % each == 0) groups.emplace_back();
    groups.back().place.push_back(place[order[i]]);
    groups.back().value.push_back(value[order[i]]);
  }
  for (Group& group : groups) {
    group.middle = optim::median(group.value);
    group.deviation = optim::median_absolute_deviation(group.value, group.middle);
  }
  return groups;
}

/// The mean of a group's samples that lie within `far` of their median, added to the result.
void add_mean(const Group& group, double far, Condensed& result) {
  double places = 0, values = 0, count = 0;
  for (std::size_t i = 0; i < group.value.size(); ++i) {
    if (std::abs(group.value[i] - group.middle) > far) {
      ++result.left_out;
      continue;
    }
    places += group.place[i], values += group.value[i], ++count;
  }
  result.place.push_back(places / count);
  result.value.push_back(values / count);
}

}  // namespace

Condensed means_of_neighbours(std::vector<double> place, std::vector<double> value,
                              std::size_t each, double resolution) {
  constexpr double kFar = 6;
  if (each <= 1) return {std::move(place), std::move(value)};
  Condensed result;
  result.each = each;
  const std::vector<Group> groups = groups_of(place, value, each);
  std::vector<double> deviations;
  for (const Group& group : groups) deviations.push_back(group.deviation);
  result.deviation = optim::median(deviations);
  // A few values may lie close by chance, and more widely where the curve is steep.
  for (const Group& group : groups) {
    add_mean(group, kFar * std::max({group.deviation, result.deviation, resolution}), result);
  }
  return result;
}

Condensed condensed(std::vector<double> place, std::vector<double> value, double resolution) {
  constexpr std::size_t kEnough = 10000;
  const std::size_t n = place.size();
  const std::size_t each = n <= kMostSamples ? 1 : (n + kEnough - 1) / kEnough;
  return means_of_neighbours(std::move(place), std::move(value), each, resolution);
}

}  // namespace camlaw::problems
