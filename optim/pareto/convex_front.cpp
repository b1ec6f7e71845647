// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "optim/pareto/measures.h"

/// Hypervolumes between and around the points of a convex front (docs/optimisation.md, "Convex
/// fronts").
namespace camlaw::optim {
namespace {

struct FrontVertex {
  double x, y;
};

/// Area between the straight piece from a to b and the reference, left of it and below it.
double area_above(FrontVertex a, FrontVertex b, const Costs& reference) {
  if (a.x >= reference[0] || b.y >= reference[1]) return 0;
  if (!(b.x > a.x)) return 0;
  const double slope = (b.y - a.y) / (b.x - a.x);
  if (a.y > reference[1]) a = {a.x + (reference[1] - a.y) / slope, reference[1]};
  if (b.x > reference[0]) b = {reference[0], a.y + slope * (reference[0] - a.x)};
  if (!(b.x > a.x)) return 0;
  return (b.x - a.x) * (reference[1] - (a.y + b.y) / 2);
}

/// Right of the last point the front goes no lower.
double area_beyond(const Costs& last, const Costs& reference) {
  return std::max(0.0, reference[0] - last[0]) * std::max(0.0, reference[1] - last[1]);
}

/// Where the supporting lines of two neighbours meet, no lower than the second.
FrontVertex meeting(const Costs& a, const std::vector<double>& of_a, const Costs& b,
                    const std::vector<double>& of_b) {
  const double low = b[1];
  const auto value_at = [](const Costs& p, const std::vector<double>& w, double x) {
    return p[1] - w[0] / w[1] * (x - p[0]);
  };
  if (!(of_a[1] > 0)) {  // upright in a
    return {a[0], std::max(low, of_b[1] > 0 ? value_at(b, of_b, a[0]) : low)};
  }
  const double slope_a = -of_a[0] / of_a[1], slope_b = of_b[1] > 0 ? -of_b[0] / of_b[1] : 0;
  double x = b[0];
  if (slope_b > slope_a) {
    x = (b[1] - a[1] + slope_a * a[0] - slope_b * b[0]) / (slope_a - slope_b);
  }
  x = std::clamp(x, a[0], b[0]);
  return {x, std::max(low, std::min(a[1], value_at(a, of_a, x)))};
}

}  // namespace

double hypervolume_of_mixtures(std::span<const Costs> front, const Costs& reference) {
  if (front.empty()) return 0;
  double area = area_beyond(front.back(), reference);
  for (std::size_t i = 1; i < front.size(); ++i) {
    const Costs &a = front[i - 1], &b = front[i];
    area += area_above({a[0], a[1]}, {b[0], b[1]}, reference);
  }
  return area;
}

double hypervolume_within(std::span<const Costs> front,
                          std::span<const std::vector<double>> weights, const Costs& reference) {
  if (front.empty()) return 0;
  double area = area_beyond(front.back(), reference);
  for (std::size_t i = 1; i < front.size(); ++i) {
    const Costs &a = front[i - 1], &b = front[i];
    const FrontVertex middle = meeting(a, weights[i - 1], b, weights[i]);
    area += area_above({a[0], a[1]}, middle, reference);
    area += area_above(middle, {b[0], b[1]}, reference);
  }
  return area;
}

}  // namespace camlaw::optim
