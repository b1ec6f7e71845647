// SPDX-License-Identifier: MIT
#include "optim/pareto/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace camlaw::optim {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

template <class Better>
Costs best_of_each(std::span<const Costs> front, Better better) {
  Costs result = front.empty() ? Costs{} : front.front();
  for (const Costs& point : front) {
    for (std::size_t i = 0; i < result.size(); ++i) {
      if (better(point[i], result[i])) result[i] = point[i];
    }
  }
  return result;
}

double sum(const Costs& costs) { return std::accumulate(costs.begin(), costs.end(), 0.0); }

double tolerance_of(const Costs& tolerances, std::size_t i) {
  return i < tolerances.size() ? tolerances[i] : 0;
}

/// For which factors on one cost the knee's sum stays the least: sum + (factor - 1) * cost.
/// `same` is what normalised costs may differ by and be equal.
void factor_range(const std::vector<Costs>& u, std::size_t knee, std::size_t objective, double same,
                  double& low, double& high) {
  low = 0;
  high = kInfinite;
  for (const Costs& other : u) {
    // sum_k + (f - 1) k <= sum_o + (f - 1) o
    const double slope = u[knee][objective] - other[objective];
    if (!(std::abs(slope) > same)) continue;
    const double room = sum(other) - sum(u[knee]);
    if (slope > 0) high = std::min(high, 1 + room / slope);
    if (slope < 0) low = std::max(low, 1 + room / slope);
  }
}

}  // namespace

Costs ideal(std::span<const Costs> front) {
  return best_of_each(front, [](double a, double b) { return a < b; });
}

Costs nadir(std::span<const Costs> front) {
  return best_of_each(front, [](double a, double b) { return a > b; });
}

Costs ranges(std::span<const Costs> front, const Costs& tolerances) {
  const Costs best = ideal(front), worst = nadir(front);
  Costs result;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const double range = worst[i] - best[i];
    const double size = std::abs(worst[i]) > 0 ? std::abs(worst[i]) : 1;
    const double same = tolerance_of(tolerances, i);
    result.push_back(range > same ? range : std::max(size, same));
  }
  return result;
}

Costs default_reference(std::span<const Costs> front, const Costs& tolerances) {
  // Of the range: measured from the nadir itself, the ends would count for nothing.
  constexpr double kShare = 0.1;
  const Costs range = ranges(front, tolerances);
  Costs reference = nadir(front);
  for (std::size_t i = 0; i < reference.size(); ++i) reference[i] += kShare * range[i];
  return reference;
}

std::vector<Costs> normalised(std::span<const Costs> front, const Costs& tolerances) {
  const Costs best = ideal(front), worst = nadir(front);
  std::vector<Costs> result(front.begin(), front.end());
  for (Costs& point : result) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double range = worst[i] - best[i];
      point[i] = range > tolerance_of(tolerances, i) ? (point[i] - best[i]) / range : 0;
    }
  }
  return result;
}

std::vector<double> steps(std::span<const Costs> front, const Costs& tolerances) {
  const std::vector<Costs> u = normalised(front, tolerances);
  std::vector<double> result;
  for (std::size_t i = 1; i < u.size(); ++i) {
    result.push_back(std::hypot(u[i][0] - u[i - 1][0], u[i][1] - u[i - 1][1]));
  }
  return result;
}

std::optional<Knee> knee(std::span<const Costs> front, const Costs& tolerances) {
  if (front.size() < 3) return {};
  const std::vector<Costs> u = normalised(front, tolerances);
  const Costs range = ranges(front, tolerances);
  const auto least = std::min_element(
      u.begin(), u.end(), [](const Costs& a, const Costs& b) { return sum(a) < sum(b); });
  const bool is_end = least->size() == 2 && ((*least)[0] == 0 || (*least)[1] == 0);
  constexpr double kBend = 1e-6;  // less is a straight line, in which rounding picks a point
  const bool is_straight = least->size() == 2 && !(sum(*least) < 1 - kBend);
  if (is_end || is_straight) return {};
  Knee result;
  result.point = static_cast<std::size_t>(least - u.begin());
  const std::size_t objectives = u.front().size();
  result.low.resize(objectives);
  result.high.resize(objectives);
  for (std::size_t i = 0; i < objectives; ++i) {
    factor_range(u, result.point, i, tolerance_of(tolerances, i) / range[i], result.low[i],
                 result.high[i]);
  }
  return result;
}

std::size_t compromise(std::span<const Costs> front, const std::vector<double>& weights,
                       const Costs& tolerances) {
  if (front.empty()) throw std::invalid_argument("weights: the front has no points");
  const bool fits = weights.size() == front.front().size();
  const bool proper = std::all_of(weights.begin(), weights.end(),
                                  [](double w) { return w >= 0 && std::isfinite(w); }) &&
                      std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0; });
  if (!fits || !proper) {
    throw std::invalid_argument(
        "weights: give one number for each objective, none negative and at least one positive");
  }
  const std::vector<Costs> u = normalised(front, tolerances);
  const auto measure = [&](const Costs& point) {
    double greatest = 0, total = 0;
    for (std::size_t i = 0; i < point.size(); ++i) {
      greatest = std::max(greatest, weights[i] * point[i]);
      total += weights[i] * point[i];
    }
    return std::pair(greatest, total);
  };
  const auto best = std::min_element(
      u.begin(), u.end(), [&](const Costs& a, const Costs& b) { return measure(a) < measure(b); });
  return static_cast<std::size_t>(best - u.begin());
}

std::optional<std::size_t> next_better(std::span<const Costs> front, std::size_t point,
                                       std::size_t objective, double share) {
  constexpr double kRounding = 1e-12;  // 0.3 less a tenth of it is 0.27
  const double here = front[point][objective];
  const double wanted = here - (share - kRounding) * std::abs(here);
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < front.size(); ++i) {
    const double its = front[i][objective];
    if (!(its < here && its <= wanted)) continue;
    if (!nearest || its > front[*nearest][objective]) nearest = i;
  }
  return nearest;
}

}  // namespace camlaw::optim
