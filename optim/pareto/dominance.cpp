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
  std::vector<bool> result(points.size(), true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    result[i] = !has_nan(points[i]);
    for (std::size_t k = 0; k < points.size() && result[i]; ++k) {
      if (k != i && !has_nan(points[k]) && dominates(points[k], points[i], tolerance)) {
        result[i] = false;
      }
    }
  }
  return result;
}

}  // namespace camlaw::optim
