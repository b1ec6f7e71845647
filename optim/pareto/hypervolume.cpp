// SPDX-License-Identifier: MIT
#include <algorithm>

#include "optim/pareto/measures.h"

namespace camlaw::optim {
namespace {

/// All below a common bound, the reference, in each of the first `costs` costs.
struct Points {
  std::vector<Costs> all;
  std::size_t costs;
};

/// Sorts by the last cost, the worst first, and leaves out what is dominated.
void tidy(Points& points) {
  const std::size_t last = points.costs - 1;
  std::sort(points.all.begin(), points.all.end(), [&](const Costs& a, const Costs& b) {
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
  for (auto next = points.all.rbegin(); next != points.all.rend(); ++next) {
    const bool dominated = std::any_of(kept.begin(), kept.end(),
                                       [&](const Costs& other) { return as_good(other, *next); });
    if (!dominated) kept.push_back(*next);
  }
  points.all.assign(kept.rbegin(), kept.rend());
}

/// Of two costs: stairs.
double area(Points points, const Costs& reference) {
  std::sort(points.all.begin(), points.all.end());
  double sum = 0, above = reference[1];
  for (const Costs& point : points.all) {
    if (!(point[1] < above)) continue;
    sum += (reference[0] - point[0]) * (above - point[1]);
    above = point[1];
  }
  return sum;
}

/// By what each point dominates alone among those after it (While, Bradstreet, Barone 2012): its
/// own box less what these dominate of it, a measure of one cost less, as none after it is worse in
/// the last.
double measure(Points points, const Costs& reference) {
  if (points.costs == 1) {
    return reference[0] - (*std::min_element(points.all.begin(), points.all.end()))[0];
  }
  if (points.costs == 2) return area(std::move(points), reference);
  tidy(points);
  const std::size_t last = points.costs - 1;
  double sum = 0;
  for (std::size_t i = 0; i < points.all.size(); ++i) {
    const Costs& own = points.all[i];
    double face = 1;
    for (std::size_t k = 0; k < last; ++k) face *= reference[k] - own[k];
    Points within{{}, last};
    for (std::size_t j = i + 1; j < points.all.size(); ++j) {
      Costs limited = points.all[j];
      for (std::size_t k = 0; k < last; ++k) limited[k] = std::max(limited[k], own[k]);
      within.all.push_back(std::move(limited));
    }
    if (!within.all.empty()) face -= measure(std::move(within), reference);
    sum += (reference[last] - own[last]) * face;
  }
  return sum;
}

}  // namespace

double hypervolume(std::span<const Costs> front, const Costs& reference) {
  Points inside{{}, reference.size()};
  for (const Costs& point : front) {
    const bool below = std::equal(point.begin(), point.end(), reference.begin(),
                                  [](double cost, double bound) { return cost < bound; });
    if (below) inside.all.push_back(point);
  }
  return inside.all.empty() ? 0 : measure(std::move(inside), reference);
}

}  // namespace camlaw::optim
