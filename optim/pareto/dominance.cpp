// SPDX-License-Identifier: MIT
#include "optim/pareto/dominance.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

bool dominates(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  bool better = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    const double size = std::min(std::abs(a[i]), std::abs(b[i]));
    const double margin = std::isinf(a[i]) || std::isinf(b[i]) ? 0 : tolerance * size;
    if (a[i] > b[i] + margin) return false;
    if (a[i] < b[i] - margin) better = true;
  }
  return better;
}

bool has_nan(const std::vector<double>& point) {
  return std::any_of(point.begin(), point.end(), [](double x) { return std::isnan(x); });
}

}  // namespace

std::vector<bool> non_dominated(std::span<const std::vector<double>> points, double tolerance) {
  std::vector<bool> result(points.size(), false);
  std::vector<std::size_t> order;  // by the first objective: what dominates is not far behind
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!has_nan(points[i])) order.push_back(i);
  }
  const auto first = [&](std::size_t i) { return points[i].empty() ? 0 : points[i][0]; };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return first(a) < first(b); });
  for (const std::size_t i : order) {
    const double here = first(i);
    const double most = std::isinf(here) ? here : here + tolerance * std::abs(here);
    result[i] = true;
    for (const std::size_t k : order) {
      if (first(k) > most) break;
      if (k == i || !dominates(points[k], points[i], tolerance)) continue;
      result[i] = false;
      break;
    }
  }
  return result;
}

}  // namespace camlaw::optim
