// SPDX-License-Identifier: MIT
#include "optim/pareto/dominance.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

using Point = std::vector<double>;

class Dominance {
 public:
  Dominance(double share, const std::vector<double>& absolute)
      : share_(share), absolute_(absolute) {}

  bool dominates(const Point& a, const Point& b) const {
    bool better = false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] == b[i]) continue;
      const double margin = margin_of(a[i], b[i], i);
      if (a[i] > b[i] + margin) return false;
      if (a[i] < b[i] - margin) better = true;
    }
    return better;
  }

  /// Whether a's first objective is so much greater that it cannot dominate b.
  bool is_behind(const Point& a, const Point& b) const {
    return !a.empty() && a[0] > b[0] + margin_of(a[0], b[0], 0);
  }

 private:
  double margin_of(double a, double b, std::size_t i) const {
    if (std::isinf(a) || std::isinf(b)) return 0;
    const double own = i < absolute_.size() ? absolute_[i] : 0;
    return std::max(own, share_ * std::min(std::abs(a), std::abs(b)));
  }

  double share_;
  const std::vector<double>& absolute_;
};

bool has_nan(const Point& point) {
  return std::any_of(point.begin(), point.end(), [](double x) { return std::isnan(x); });
}

}  // namespace

std::vector<bool> non_dominated(std::span<const Point> points, double tolerance,
                                const std::vector<double>& tolerances) {
  const Dominance order_of(tolerance, tolerances);
  std::vector<std::size_t> order, kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!has_nan(points[i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] < points[b] || (points[a] == points[b] && a < b);
  });
  for (const std::size_t i : order) {
    const bool out = std::any_of(kept.begin(), kept.end(), [&](std::size_t k) {
      return order_of.dominates(points[k], points[i]);
    });
    if (out) continue;
    // What it dominates is not far before it.
    auto from = kept.end();
    while (from != kept.begin() && !order_of.is_behind(points[i], points[*(from - 1)])) --from;
    kept.erase(
        std::remove_if(from, kept.end(),
                       [&](std::size_t k) { return order_of.dominates(points[i], points[k]); }),
        kept.end());
    kept.push_back(i);
  }
  std::vector<bool> result(points.size(), false);
  for (const std::size_t k : kept) result[k] = true;
  return result;
}

}  // namespace camlaw::optim
