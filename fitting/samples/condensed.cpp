// SPDX-License-Identifier: MIT
#include "fitting/samples/condensed.h"

#include <algorithm>
#include <cmath>
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
  const std::vector<std::size_t> order = optim::order_of(place);
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

/// |second differences| of numbers that are `lag` apart.
std::vector<double> second_differences(const std::vector<double>& values, std::size_t lag) {
  std::vector<double> result;
  for (std::size_t i = 2 * lag; i < values.size(); ++i) {
    result.push_back(std::abs(values[i] - 2 * values[i - lag] + values[i - 2 * lag]));
  }
  return result;
}

/// How many neighbours a mean may stand for: so many that there are 10000 means, but fewer where
/// the curve bends within a mean by more than a hundredth of the mean's noise, as in records with
/// next to no noise. A stretch of width w lies s'' w^2 / 24 beside the curve by its mean; the noise
/// and the bend are those of second differences.
std::size_t each_by_noise(const std::vector<double>& place, const std::vector<double>& value,
                          double resolution) {
  // Fits are no better with more means. Second differences over ten means show a bend that noise
  // hides from neighbours.
  constexpr std::size_t kEnough = 10000, kLag = 10;
  // A hundredth of a mean's noise moves no fit. The largest tenth of the bends may be corners or
  // outliers.
  constexpr double kOfNoise = 0.01, kMost = 0.9;
  constexpr double kNoiseInMost = 4.5;  // of noise alone 9 in 10 second differences are below
  const std::size_t n = place.size(), each = (n + kEnough - 1) / kEnough;
  std::vector<double> sorted, means;
  for (const std::size_t i : optim::order_of(place)) sorted.push_back(value[i]);
  for (std::size_t i = 0; i + each <= n; i += each) {
    const auto begin = sorted.begin() + static_cast<std::ptrdiff_t>(i);
    means.push_back(std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(each), 0.0) /
                    static_cast<double>(each));
  }
  const double of_normal = 0.6745 * std::sqrt(6.0);  // the median of |second differences|
  const double noise = std::max(optim::median(second_differences(sorted, 1)) / of_normal,
                                resolution / std::sqrt(12.0)) /
                       std::sqrt(static_cast<double>(each));
  std::vector<double> bends = second_differences(means, kLag);
  const auto most =
      bends.begin() + static_cast<std::ptrdiff_t>(kMost * static_cast<double>(bends.size()));
  std::nth_element(bends.begin(), most, bends.end());
  const double bend = std::max(0.0, *most - kNoiseInMost * noise) / (24.0 * kLag * kLag);
  if (bend <= kOfNoise * noise) return each;
  // The bend grows as the square of the width, and the noise falls as its root.
  const double share = std::pow(kOfNoise * noise / bend, 0.4);
  return std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(each)));
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
  constexpr double kFar = 6;  // deviations, of as many values of one place as there may be
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

Condensed condensed(std::vector<double> place, std::vector<double> value, double resolution,
                    std::size_t most_means) {
  const std::size_t n = place.size();
  if (n <= kMostSamples) return {std::move(place), std::move(value)};
  const std::size_t least = (n + most_means - 1) / most_means;
  const std::size_t each = std::max(least, each_by_noise(place, value, resolution));
  return means_of_neighbours(std::move(place), std::move(value), each, resolution);
}

}  // namespace camlaw::problems
