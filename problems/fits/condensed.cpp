// SPDX-License-Identifier: MIT
#include "problems/fits/condensed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "optim/fit/statistics.h"

namespace camlaw::problems {
namespace {

/// The mean of a group's samples that lie near their median, added to the result.
void add_mean(const std::vector<double>& place, const std::vector<double>& value,
              Condensed& result) {
  constexpr double kFar = 6;
  const double middle = optim::median(value);
  const double far = kFar * optim::median_absolute_deviation(value, middle);
  double places = 0, values = 0, count = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (std::abs(value[i] - middle) > far) {
      ++result.left_out;
      continue;
    }
    places += place[i], values += value[i], ++count;
  }
  result.place.push_back(places / count);
  result.value.push_back(values / count);
}

}  // namespace

Condensed condensed(std::vector<double> place, std::vector<double> value) {
  constexpr std::size_t kEnough = 10000;
  const std::size_t n = place.size();
  if (n <= kMostSamples) return {std::move(place), std::move(value)};
  Condensed result;
  result.each = (n + kEnough - 1) / kEnough;
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return place[a] < place[b]; });
  std::vector<double> places, values;
  for (std::size_t i = 0; i < n; ++i) {
    places.push_back(place[order[i]]);
    values.push_back(value[order[i]]);
    if (places.size() < result.each && i + 1 < n) continue;
    add_mean(places, values, result);
    places.clear(), values.clear();
  }
  return result;
}

}  // namespace camlaw::problems
