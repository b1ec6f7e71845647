// SPDX-License-Identifier: MIT
#include "optim/pareto/dominance.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

using CostPoint = std::vector<double>;

class Dominance {
 public:
  Dominance(double share, const std::vector<double>& absolute)
      : share_(share), absolute_(absolute) {}

  /// Nothing is greater by more than its tolerance, and something smaller by more than that.
  bool dominates(const CostPoint& a, const CostPoint& b) const {
    bool better = false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] == b[i]) continue;
      const double margin = margin_of(a[i], b[i], i);
      if (a[i] > b[i] + margin) return false;
      if (a[i] < b[i] - margin) better = true;
    }
    return better;
  }

  /// Nothing is greater at all: that is transitive, and what a dominates then whatever dominates a
  /// does too.
  bool dominates_outright(const CostPoint& a, const CostPoint& b) const {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] > b[i]) return false;
    }
    return dominates(a, b);
  }

  /// Whether a's first objective is so much greater that it cannot dominate b.
  bool is_behind(const CostPoint& a, const CostPoint& b) const {
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

bool has_nan(const CostPoint& point) {
  return std::any_of(point.begin(), point.end(), [](double x) { return std::isnan(x); });
}

/// In lexicographic order those that no other dominates outright.
std::vector<std::size_t> outright(std::span<const CostPoint> points, const Dominance& relation) {
  std::vector<std::size_t> order, kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!has_nan(points[i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] < points[b] || (points[a] == points[b] && a < b);
  });
  for (const std::size_t i : order) {
    const bool out = std::any_of(kept.begin(), kept.end(), [&](std::size_t k) {
      return relation.dominates_outright(points[k], points[i]);
    });
    if (!out) kept.push_back(i);
  }
  return kept;
}

/// Points in lexicographic order become those that stay.
class Sieve {
 public:
  Sieve(std::span<const CostPoint> points, std::vector<std::size_t> order,
        const Dominance& relation)
      : points_(points),
        order_(std::move(order)),
        relation_(relation),
        dominators_(order_.size(), 0),
        decided_(order_.size(), false) {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      for_each_dominated(i, [&](std::size_t k) { ++dominators_[k]; });
    }
  }

  std::vector<std::size_t> find() {
    std::vector<std::size_t> stay;
    std::vector<std::size_t> free;
    for (std::size_t i = order_.size(); i-- > 0;) {
      if (dominators_[i] == 0) free.push_back(i);
    }
    std::size_t first = 0;  // all before it are decided
    for (;;) {
      while (first < order_.size() && decided_[first]) ++first;
      if (first == order_.size()) return stay;
      const bool is_ring = free.empty();
      const std::size_t next = is_ring ? first : free.back();
      if (!is_ring) free.pop_back();
      if (decided_[next]) continue;
      decided_[next] = true;
      stay.push_back(order_[next]);
      if (is_ring) remove_dominators(next, free);
      for_each_dominated(next, [&](std::size_t k) { remove(k, free); });
    }
  }

 private:
  const CostPoint& point(std::size_t i) const { return points_[order_[i]]; }

  /// Those that are not decided; what is dominated is not far before what dominates it.
  template <class F>
  void for_each_dominated(std::size_t i, F f) const {
    std::size_t from = i;
    while (from > 0 && !relation_.is_behind(point(i), point(from - 1))) --from;
    for (std::size_t k = from; k < order_.size(); ++k) {
      if (k != i && !decided_[k] && relation_.dominates(point(i), point(k))) f(k);
    }
  }

  void remove(std::size_t i, std::vector<std::size_t>& free) {
    decided_[i] = true;
    for_each_dominated(i, [&](std::size_t k) {
      if (--dominators_[k] == 0) free.push_back(k);
    });
  }

  void remove_dominators(std::size_t i, std::vector<std::size_t>& free) {
    for (std::size_t k = 0; k < order_.size(); ++k) {
      if (!decided_[k] && relation_.dominates(point(k), point(i))) remove(k, free);
    }
  }

  std::span<const CostPoint> points_;
  std::vector<std::size_t> order_;
  const Dominance& relation_;
  std::vector<std::size_t> dominators_;  ///< that are not decided
  std::vector<bool> decided_;
};

}  // namespace

std::vector<bool> non_dominated(std::span<const CostPoint> points, double tolerance,
                                const std::vector<double>& tolerances) {
  const Dominance relation(tolerance, tolerances);
  std::vector<bool> result(points.size(), false);
  for (const std::size_t k : Sieve(points, outright(points, relation), relation).find()) {
    result[k] = true;
  }
  return result;
}

}  // namespace camlaw::optim
