// SPDX-License-Identifier: MIT
#include <algorithm>

#include "optim/pareto/measures.h"

namespace camlaw::optim {
namespace {

/// Sorts by the last cost, the worst first, and leaves out what is dominated.
void tidy(std::vector<Costs>& points) {
  const std::size_t last = points.front().size() - 1;
  std::sort(points.begin(), points.end(), [&](const Costs& a, const Costs& b) {
    if (a[last] != b[last]) return a[last] > b[last];
    return std::lexicographical_compare(b.begin(), b.begin() + last, a.begin(), a.begin() + last);
  });
  const auto as_good = [&](const Costs& a, const Costs& b) {
    for (std::size_t k = 0; k < last; ++k) {
      if (a[k] > b[k]) return false;
    }
    return true;  // the last cost is no worse by the order
  };
  std::vector<Costs> kept;
  for (auto next = points.rbegin(); next != points.rend(); ++next) {
    const bool dominated = std::any_of(kept.begin(), kept.end(),
                                       [&](const Costs& other) { return as_good(other, *next); });
    if (!dominated) kept.push_back(*next);
  }
  points.assign(kept.rbegin(), kept.rend());
}

/// Of two costs: stairs.
double area(std::vector<Costs> points, const Costs& reference) {
  std::sort(points.begin(), points.end());
  double sum = 0, above = reference[1];
  for (const Costs& point : points) {
    if (!(point[1] < above)) continue;
    sum += (reference[0] - point[0]) * (above - point[1]);
    above = point[1];
  }
  return sum;
}

/// By what each point dominates alone among those after it (While, Bradstreet, Barone 2012): its
/// own box less what these dominate of it, a measure of one cost less, as none after it is worse in
/// the last.
/// Of the reference the first costs count, as many as the points have.
double measure(std::vector<Costs> points, const Costs& reference) {
  const std::size_t last = points.front().size() - 1;
  if (last == 0) return reference[0] - std::min_element(points.begin(), points.end())->front();
  if (last == 1) return area(std::move(points), reference);
  tidy(points);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Costs& own = points[i];
    double face = 1;
    for (std::size_t k = 0; k < last; ++k) face *= reference[k] - own[k];
    std::vector<Costs> within;
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      Costs& limited = within.emplace_back(points[j].begin(), points[j].end() - 1);
      for (std::size_t k = 0; k < last; ++k) limited[k] = std::max(limited[k], own[k]);
    }
    if (!within.empty()) face -= measure(std::move(within), reference);
    sum += (reference[last] - own[last]) * face;
  }
  return sum;
}

}  // namespace

double hypervolume(std::span<const Costs> front, const Costs& reference) {
  std::vector<Costs> inside;
  for (const Costs& point : front) {
    const bool below = std::equal(point.begin(), point.end(), reference.begin(),
                                  [](double cost, double bound) { return cost < bound; });
    if (below) inside.push_back(point);
  }
  return inside.empty() ? 0 : measure(std::move(inside), reference);
}

}  // namespace camlaw::optim
