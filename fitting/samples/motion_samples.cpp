// SPDX-License-Identifier: MIT
#include "fitting/samples/motion_samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fitting/samples/lift_samples.h"
#include "numerics/linear/statistics.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

/// The median of the few outermost values, which a far-off one does not move.
double outer_value(const MotionSamples& samples, bool first) {
  std::vector<std::size_t> order(samples.place.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t few = samples.place.size() < 30 ? 1 : 3;
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(few), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return first ? samples.place[a] < samples.place[b]
                                   : samples.place[a] > samples.place[b];
                    });
  std::vector<double> values;
  for (std::size_t i = 0; i < few; ++i) values.push_back(samples.value[order[i]]);
  return optim::median(values);
}

/// What neighbours show of it; none where there are too few.
double noise_of(const MotionSamples& samples) {
  const std::vector<std::size_t> order = optim::order_of(samples.place);
  std::vector<double> place, value;
  for (const std::size_t i : order) {
    if (!place.empty() && samples.place[i] == place.back()) continue;
    place.push_back(samples.place[i]), value.push_back(samples.value[i]);
  }
  const auto noise = possible_noise(place, value);
  return noise ? *noise : 0;
}

}  // namespace

double rounding_deviation(const MotionSamples& samples) {
  return samples.resolution / std::sqrt(12.0);
}

MotionSamples between(const MotionSamples& all, double low, double high, double period) {
  MotionSamples part = all.none();
  for (std::size_t i = 0; i < all.place.size(); ++i) {
    double place = all.place[i];
    if (period > 0) place = in_period(place, low, period);
    if (place < low || place > high) continue;
    part.place.push_back(place);
    part.value.push_back(all.value[i]);
  }
  return part;
}

MotionGuess guess_motion(const MotionSamples& samples) {
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  MotionGuess guess;
  guess.begin = *low;
  guess.end = *high;
  if (samples.order == 0) {
    guess.from = outer_value(samples, true);
    guess.to = outer_value(samples, false);
    return guess;
  }
  // Of a derivative: where it is not zero, the stroke by its greatest value.
  double greatest = 0;
  for (const double v : samples.value) {
    if (std::abs(v) > std::abs(greatest)) greatest = v;
  }
  constexpr double kRest = 0.01, kNoise = 4;  // of the greatest, of the noise
  const double rest = std::max(kRest * std::abs(greatest), kNoise * noise_of(samples));
  double begin = guess.end, end = guess.begin;
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (!(std::abs(samples.value[i]) > rest)) continue;
    begin = std::min(begin, samples.place[i]);
    end = std::max(end, samples.place[i]);
  }
  if (end > begin) guess = {begin, end, 0, 1};
  // About those of the modified sine, 1.76 and 5.53, in the middle of common laws.
  constexpr double kTypicalB = 1.8, kTypicalC = 5.5;
  const double length = guess.end - guess.begin;
  guess.from = 0;
  guess.to =
      samples.order == 1 ? greatest * length / kTypicalB : greatest * length * length / kTypicalC;
  return guess;
}

}  // namespace camlaw::problems
