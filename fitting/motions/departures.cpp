// SPDX-License-Identifier: MIT
#include "fitting/motions/departures.h"

#include <algorithm>
#include <cmath>

namespace camlaw::problems {
namespace {

constexpr std::size_t kHalf = 4;  // neighbours to either side
constexpr double kCount = 2 * kHalf + 1;

struct LeftOver {
  double place, value;  ///< sample less law
};

/// What the law leaves, by place.
std::vector<LeftOver> left_of(const MotionSamples& samples, const LawFit& fit) {
  std::vector<LeftOver> left;
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    const double place = samples.place[i];
    left.push_back({place, samples.value[i] - fit.value(place, samples.order)});
  }
  std::sort(left.begin(), left.end(),
            [](const LeftOver& a, const LeftOver& b) { return a.place < b.place; });
  return left;
}

/// On which side of the law the neighbours of sample k lie together: 1, -1, or 0 on none.
int side_at(const std::vector<LeftOver>& left, std::size_t k, double noise) {
  constexpr double kBeyond = 4.5;
  const std::size_t first = std::min(std::max(k, kHalf) - kHalf, left.size() - 2 * kHalf - 1);
  double mean = 0;
  for (std::size_t j = first; j <= first + 2 * kHalf; ++j) mean += left[j].value / kCount;
  if (std::abs(mean) * std::sqrt(kCount) <= kBeyond * noise) return 0;
  return mean > 0 ? 1 : -1;
}

/// A stretch begins and ends before its mean tells it from the noise: half a window further out.
void reach_out(std::vector<Departure>& found, const std::vector<LeftOver>& left) {
  for (Departure& stretch : found) {
    const auto at = [&](double place) {
      return std::lower_bound(left.begin(), left.end(), place,
                              [](const LeftOver& l, double p) { return l.place < p; }) -
             left.begin();
    };
    const auto half = static_cast<std::ptrdiff_t>(kHalf);
    const auto last = static_cast<std::ptrdiff_t>(left.size()) - 1;
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(at(stretch.from) - half, 0);
    const std::ptrdiff_t to = std::min(at(stretch.to) + half, last);
    stretch.from = left[static_cast<std::size_t>(from)].place;
    stretch.to = left[static_cast<std::size_t>(to)].place;
    stretch.count = static_cast<std::size_t>(to - from + 1);
  }
}

}  // namespace

std::vector<Departure> departures(const MotionSamples& samples, const LawFit& fit, double noise) {
  constexpr double kMost = 1.0 / 3;
  const std::vector<LeftOver> left = left_of(samples, fit);
  if (left.size() < 2 * kHalf + 1) return {};
  std::vector<Departure> found;
  std::size_t count = 0;
  int before = 0;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const int side = side_at(left, k, noise);
    if (side != 0) {
      if (side != before) found.push_back({left[k].place, left[k].place, 0, 0});
      Departure& stretch = found.back();
      stretch.to = left[k].place;
      ++stretch.count, ++count;
      if (std::abs(left[k].value) > std::abs(stretch.most)) stretch.most = left[k].value;
    }
    before = side;
  }
  if (static_cast<double>(count) > kMost * static_cast<double>(left.size())) return {};
  reach_out(found, left);
  return found;
}

bool departs(double place, const std::vector<Departure>& stretches, double period) {
  return std::any_of(stretches.begin(), stretches.end(), [&](const Departure& stretch) {
    double ahead = place - stretch.from;
    if (period > 0) ahead -= period * std::floor(ahead / period);
    return ahead >= 0 && ahead <= stretch.to - stretch.from;
  });
}

MotionSamples without(const MotionSamples& samples, const std::vector<Departure>& stretches,
                      double period) {
  MotionSamples result = samples.none();
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (departs(samples.place[i], stretches, period)) continue;
    result.place.push_back(samples.place[i]);
    result.value.push_back(samples.value[i]);
  }
  return result;
}

}  // namespace camlaw::problems
