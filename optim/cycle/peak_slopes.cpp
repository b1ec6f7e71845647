// SPDX-License-Identifier: MIT
#include "optim/cycle/peak_slopes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "optim/cycle/moving_jumps.h"

namespace camlaw::optim {
namespace {

std::vector<double> slopes_at(const Curve& curve, Place place, Design x) {
  const Function f = curve.at(curve.tied(place, x));
  std::vector<double> own(f.inputs().size()), all(x.size(), 0.0);
  f.gradient(x, own);
  for (std::size_t k = 0; k < own.size(); ++k) all[f.inputs()[k]] += own[k];
  return all;
}

/// The two sides of a corner, and the share of the left one in the peak's slopes.
struct Corner {
  Place left, right;
  double share;
};

/// A peak between breaks at which the slope does not go through zero but jumps over it: beside it
/// the slope is about the same at twice the distance. Where it goes through zero it is twice as
/// large there.
std::optional<Corner> corner_at(const Trace& trace, Place place) {
  constexpr double kBeside = 1e-7;  // of the stretch
  constexpr double kSame = 0.75;    // half way between a smooth peak and a corner
  constexpr double kLevel = 1e-6;   // a side on which the curve is level beside the other
  const std::vector<double> breaks = trace.breaks();
  const auto after = std::upper_bound(breaks.begin(), breaks.end(), place.angle);
  if (after == breaks.begin() || after == breaks.end()) return {};
  const double begin = *(after - 1), end = *after, step = kBeside * (end - begin);
  if (!(place.angle - 2 * step > begin && place.angle + 2 * step < end)) return {};
  const auto slope = [&](double distance) { return trace.at({place.angle + distance})[1]; };
  const double left = slope(-step), right = slope(step);
  const double size = std::max(std::abs(left), std::abs(right));
  // A top that is level to rounding has slopes of either sign, which are none.
  constexpr double kRounding = 1e-10;
  const double value = std::abs(trace.at(place)[0]), least = kRounding * value / (end - begin);
  if (!(size > least && std::isfinite(size)) || left * right > 0) return {};
  const auto stays = [&](double near, double distance) {
    return std::abs(near) <= kLevel * size || std::abs(near) > kSame * std::abs(slope(distance));
  };
  if (!stays(left, -2 * step) || !stays(right, 2 * step)) return {};
  return Corner{{place.angle - step},
                {place.angle + step},
                std::abs(right) / (std::abs(left) + std::abs(right))};
}

}  // namespace

PeakSlopes peak_slopes(const Curve& curve, const Trace& trace, Place place, Design x) {
  const std::vector<double> moved = jump_motion(curve, place, x);
  if (!moved.empty()) {
    PeakSlopes result{slopes_at(curve, place, x), true};
    const double along = trace.at(place)[1];
    for (std::size_t i = 0; i < x.size(); ++i) result.by[i] += along * moved[i];
    return result;
  }
  const auto corner = corner_at(trace, place);
  if (!corner) return {slopes_at(curve, place, x)};
  PeakSlopes result{slopes_at(curve, corner->left, x), true};
  const std::vector<double> right = slopes_at(curve, corner->right, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    result.by[i] = corner->share * result.by[i] + (1 - corner->share) * right[i];
  }
  return result;
}

}  // namespace camlaw::optim
