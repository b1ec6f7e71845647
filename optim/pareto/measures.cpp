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

/// Of a tolerance or a size; 0 where it is not known.
double of_cost(const Costs& values, std::size_t i) { return i < values.size() ? values[i] : 0; }

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

CostScale::CostScale(double ideal, double nadir, double tolerance, double size)
    : ideal_(ideal), range_(nadir - ideal) {
  // Sizes: a range up to which a cost is counted in proportion, all of it.
  constexpr double kStraight = 10;
  if (!(range_ > tolerance)) {
    range_ = std::max(std::abs(nadir) > 0 ? std::abs(nadir) : 1, tolerance);
    size = 0;
  }
  const double most = kStraight * size;
  straight_ = size > 0 ? std::min(range_, std::max(size, most * (most / range_))) : range_;
  unit_ = straight_ * (1 + std::log(range_ / straight_));
}

double CostScale::place(double cost) const {
  const double beyond = cost - ideal_;
  if (!(beyond > straight_)) return beyond / unit_;
  return straight_ / unit_ * (1 + std::log(beyond / straight_));
}

double CostScale::cost(double place) const {
  const double beyond = place * unit_;
  if (!(beyond > straight_)) return ideal_ + beyond;
  return ideal_ + straight_ * std::exp(beyond / straight_ - 1);
}

double CostScale::slope(double cost) const {
  return unit_ * std::max(1.0, (cost - ideal_) / straight_);
}

double CostScale::middle(double low, double high) const {
  if (!(high - ideal_ > straight_)) return low + (high - low) / 2;
  return std::clamp(cost((place(low) + place(high)) / 2), low, high);
}

std::vector<CostScale> cost_scales(std::span<const Costs> front, const Costs& tolerances,
                                   const Costs& sizes) {
  const Costs best = ideal(front), worst = nadir(front);
  std::vector<CostScale> result;
  for (std::size_t i = 0; i < best.size(); ++i) {
    result.emplace_back(best[i], worst[i], of_cost(tolerances, i), of_cost(sizes, i));
  }
  return result;
}

Costs ranges(std::span<const Costs> front, const Costs& tolerances) {
  Costs result;
  for (const CostScale& scale : cost_scales(front, tolerances)) result.push_back(scale.range());
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

std::vector<Costs> normalised(std::span<const Costs> front, const Costs& tolerances,
                              const Costs& sizes) {
  const Costs best = ideal(front), worst = nadir(front);
  const std::vector<CostScale> scales = cost_scales(front, tolerances, sizes);
  std::vector<Costs> result(front.begin(), front.end());
  for (Costs& point : result) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const bool varies = worst[i] - best[i] > of_cost(tolerances, i);
      point[i] = varies ? scales[i].place(point[i]) : 0;
    }
  }
  return result;
}

std::vector<double> steps(std::span<const Costs> front, const Costs& tolerances,
                          const Costs& sizes) {
  const std::vector<Costs> u = normalised(front, tolerances, sizes);
  std::vector<double> result;
  for (std::size_t i = 1; i < u.size(); ++i) {
    result.push_back(std::hypot(u[i][0] - u[i - 1][0], u[i][1] - u[i - 1][1]));
  }
  return result;
}

std::optional<Knee> knee(std::span<const Costs> front, const Costs& tolerances,
                         const Costs& sizes) {
  if (front.size() < 3) return {};
  const std::vector<Costs> u = normalised(front, tolerances, sizes);
  const std::vector<CostScale> scales = cost_scales(front, tolerances, sizes);
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
    const double same = of_cost(tolerances, i) / scales[i].slope(front[result.point][i]);
    factor_range(u, result.point, i, same, result.low[i], result.high[i]);
  }
  return result;
}

std::size_t compromise(std::span<const Costs> front, const std::vector<double>& weights,
                       const Costs& tolerances, const Costs& sizes) {
  if (front.empty()) throw std::invalid_argument("weights: the front has no points");
  const bool fits = weights.size() == front.front().size();
  const bool proper = std::all_of(weights.begin(), weights.end(),
                                  [](double w) { return w >= 0 && std::isfinite(w); }) &&
                      std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0; });
  if (!fits || !proper) {
    throw std::invalid_argument(
        "weights: give one number for each objective, none negative and at least one positive");
  }
  const std::vector<Costs> u = normalised(front, tolerances, sizes);
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
