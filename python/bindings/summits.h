// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "optim/problem/curve.h"

namespace camlaw::python {

/// Where a curve is sampled: evenly in each stretch between two breaks, in more places where the
/// stretch is long.
struct SampledPlaces {
  std::vector<optim::Place> places;
  std::vector<std::size_t> begins;  ///< of the stretches among the places, and the end

  explicit SampledPlaces(const std::vector<double>& breaks) {
    constexpr int kSamples = 144, kLeast = 8;
    const double cycle = breaks.back() - breaks.front();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const double share = (breaks[k + 1] - breaks[k]) / cycle;
      const int steps = std::max(kLeast, static_cast<int>(kSamples * share));
      const auto here = optim::even_places(breaks[k], breaks[k + 1], steps);
      begins.push_back(places.size());
      places.insert(places.end(), here.begin(), here.end());
    }
    begins.push_back(places.size());
  }
};

/// Finds how high a curve goes, by its values at the samples. `derivatives(place, stretch)` gives
/// value, slope and second derivative; it is asked for only where the samples show a summit.
template <class Derivatives>
class Summits {
 public:
  Summits(const SampledPlaces& at, std::span<const double> values, const Derivatives& derivatives)
      : at_(at), values_(values), derivatives_(derivatives) {}

  /// The highest of sign * curve, turned back; NaN where a sample is.
  double highest(double sign) const {
    double seen = -optim::kInfinity;
    for (const double value : values_) {
      if (std::isnan(value)) return value;
      seen = std::max(seen, sign * value);
    }
    if (!std::isfinite(seen)) return sign * seen;
    double best = seen;
    for (std::size_t k = 0; k + 1 < at_.begins.size(); ++k) {
      for (std::size_t i = at_.begins[k]; i < at_.begins[k + 1]; ++i) {
        if (may_exceed(i, k, sign, seen)) best = std::max(best, summit(i, k, sign));
      }
    }
    return sign * best;
  }

  /// The same of a part of the curve; of its magnitude a number of no sign.
  double extreme(optim::Part part) const {
    if (part == optim::Part::Highest) return highest(1);
    if (part == optim::Part::Lowest) return highest(-1);
    const double up = highest(1), down = highest(-1);
    return std::max(std::abs(up), std::abs(down));
  }

 private:
  /// Whether a sample is a local maximum from which the curve may rise to what was seen: a parabola
  /// through it and its neighbours rises by an eighth of their second difference.
  bool may_exceed(std::size_t i, std::size_t stretch, double sign, double seen) const {
    constexpr double kRise = 0.5;  // four times that, for curves that are not parabolas
    const std::size_t first = at_.begins[stretch], last = at_.begins[stretch + 1] - 1;
    const double here = sign * values_[i];
    const double left = sign * values_[i == first ? i + 1 : i - 1];
    const double right = sign * values_[i == last ? i - 1 : i + 1];
    if (here < left || here < right || (here == left && here == right)) return false;
    return here + kRise * std::abs(left - 2 * here + right) >= seen;
  }

  /// Newton's method on the slope, kept between the neighbours by bisection.
  double summit(std::size_t i, std::size_t stretch, double sign) const {
    constexpr int kSteps = 40;
    constexpr double kClose = 1e-9;  // of the bracket: the value is then right to its square
    const std::size_t first = at_.begins[stretch], last = at_.begins[stretch + 1] - 1;
    double left = at_.places[i == first ? i : i - 1].angle;
    double right = at_.places[i == last ? i : i + 1].angle;
    const double close = kClose * (right - left);
    optim::Place place = at_.places[i];
    double best = -optim::kInfinity;
    for (int step = 0; step < kSteps; ++step) {
      const auto f = derivatives_(place, stretch);
      best = std::max(best, sign * f[0]);
      const double slope = sign * f[1], bend = sign * f[2];
      const bool ends = (place.angle <= left && slope <= 0) || (place.angle >= right && slope >= 0);
      if (ends || !(std::abs(slope) > 0)) break;
      (slope > 0 ? left : right) = place.angle;
      const double newton = place.angle - slope / bend;
      const bool inside = bend < 0 && newton > left && newton < right;
      const double next = inside ? newton : std::midpoint(left, right);
      if (std::abs(next - place.angle) <= close) break;
      place = {next};
    }
    return best;
  }

  const SampledPlaces& at_;
  std::span<const double> values_;
  const Derivatives& derivatives_;
};

}  // namespace camlaw::python
