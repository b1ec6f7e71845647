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
  constexpr double kBeyond = 4.5;  // deviations: noise passes them once in 150 000 samples
  const std::size_t first = std::min(std::max(k, kHalf) - kHalf, left.size() - 2 * kHalf - 1);
  double mean = 0;
  for (std::size_t j = first; j <= first + 2 * kHalf; ++j) mean += left[j].value / kCount;
  if (std::abs(mean) * std::sqrt(kCount) <= kBeyond * noise) return 0;
  return mean > 0 ? 1 : -1;
}

/// What lies between the samples and the law at sample k: of the parabola through nine neighbours,
/// which are evenly apart or nearly so, by orthogonal polynomials 1, t, t^2 - 20/3 of t = -4 to 4.
double difference_at(const std::vector<LeftOver>& left, std::size_t k) {
  constexpr double kMean = 20.0 / 3;              // of t^2
  constexpr double kOfSlope = 60, kOfBend = 308;  // sums of squares
  const std::size_t first = std::min(std::max(k, kHalf) - kHalf, left.size() - 2 * kHalf - 1);
  const auto from_middle = [&](std::size_t i) {
    return static_cast<double>(i) - static_cast<double>(first + kHalf);
  };
  const double at = from_middle(k);
  double sum = 0;
  for (std::size_t i = first; i <= first + 2 * kHalf; ++i) {
    const double t = from_middle(i);
    sum += left[i].value *
           (1 / kCount + at * t / kOfSlope + (at * at - kMean) * (t * t - kMean) / kOfBend);
  }
  return sum;
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

/// Stretches on one side that meet are one.
std::vector<Departure> joined(const std::vector<Departure>& stretches) {
  std::vector<Departure> result;
  for (const Departure& d : stretches) {
    const bool is_apart =
        result.empty() || d.from > result.back().to || (d.most > 0) != (result.back().most > 0);
    if (is_apart) {
      result.push_back(d);
      continue;
    }
    Departure& before = result.back();
    before.count += d.count;
    before.to = std::max(before.to, d.to);
    if (std::abs(d.most) > std::abs(before.most)) before.most = d.most;
  }
  return result;
}

}  // namespace

std::vector<Departure> departures(const MotionSamples& samples, const LawFit& fit, double noise) {
  constexpr double kMost = 0.5;  // where more depart, the law is not that of the samples
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
      const double difference = difference_at(left, k);
      if (side * difference > side * stretch.most) stretch.most = difference;
    }
    before = side;
  }
  if (static_cast<double>(count) > kMost * static_cast<double>(left.size())) return {};
  std::erase_if(found, [&](const Departure& d) { return std::abs(d.most) <= samples.resolution; });
  reach_out(found, left);
  return joined(found);
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
