// SPDX-License-Identifier: MIT
#include "fitting/samples/lone_samples.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numerics/polynomial/lagrange.h"

namespace camlaw::problems {
namespace {

constexpr std::size_t kNearest = 4;  // neighbours on each side that a sample is judged by

/// The nearest samples that are not left out, the nearest of each side first.
struct Neighbours {
  std::vector<std::size_t> left, right;
};

Neighbours neighbours_of(const std::vector<bool>& left_out, std::size_t i) {
  Neighbours near;
  for (std::size_t k = i; k-- > 0 && near.left.size() < kNearest;) {
    if (!left_out[k]) near.left.push_back(k);
  }
  for (std::size_t k = i + 1; k < left_out.size() && near.right.size() < kNearest; ++k) {
    if (!left_out[k]) near.right.push_back(k);
  }
  return near;
}

struct LoneSearch {
  std::span<const double> x, s;
  double noise;

  double miss(const std::vector<bool>& left_out, std::size_t i) const {
    return std::abs(miss_without(x, s, left_out, i).by);
  }

  /// What samples near the i-th miss each other's cubic by, at most; 0 where it may be noise.
  double hidden_beside(const std::vector<bool>& is_off, std::size_t i) const {
    constexpr double kChance = 3;  // deviations
    double most = 0, in_noise = 0;
    const Neighbours near = neighbours_of(is_off, i);
    for (const auto* side : {&near.left, &near.right}) {
      for (const std::size_t k : *side) {
        const CubicMiss own = miss_without(x, s, is_off, k);
        most = std::max(most, std::abs(own.by));
        in_noise = std::max(in_noise, std::abs(own.by) / own.noise);
      }
    }
    return in_noise > kChance * noise ? most : 0;
  }

  /// Of a few suspects that have neighbours in common puts back the one that misses least, as long
  /// as the step may hide what it misses.
  void put_back_hidden(const std::vector<std::size_t>& group, std::vector<bool>& is_off) const {
    constexpr double kOdd = 4;  // a sample of an exact law reaches 2, at any step and corner
    for (bool again = true; again;) {
      std::optional<std::size_t> least;
      double by = 0;
      for (const std::size_t i : group) {
        if (!is_off[i]) continue;
        const double own = miss(is_off, i);
        const bool is_hidden = own <= kOdd * hidden_beside(is_off, i);  // not where it is none
        if (!is_hidden || (least && own >= by)) continue;
        least = i;
        by = own;
      }
      if (least) is_off[*least] = false;
      again = least.has_value();
    }
  }
};

/// Suspects so near each other that they have neighbours in common.
std::vector<std::vector<std::size_t>> grouped(const std::vector<bool>& is_off) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < is_off.size(); ++i) {
    if (!is_off[i]) continue;
    if (groups.empty() || i > groups.back().back() + 2 * kNearest) groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

}  // namespace

CubicMiss cubic_miss(std::span<const double> x, std::span<const double> s,
                     std::span<const std::size_t> at, std::size_t i) {
  double left = s[i], squares = 1;
  for (const std::size_t k : at) {
    const double weight = lagrange_weight(x, at, k, i);
    left -= weight * s[k];
    squares += weight * weight;
  }
  return {left, std::sqrt(squares)};
}

CubicMiss miss_without(std::span<const double> x, std::span<const double> s,
                       const std::vector<bool>& left_out, std::size_t i) {
  constexpr std::size_t kPoints = 4;  // a cubic takes four
  const auto [left, right] = neighbours_of(left_out, i);
  std::vector<std::size_t> at;
  for (std::size_t k = 0; k < kPoints && at.size() < kPoints; ++k) {
    if (k < left.size()) at.push_back(left[k]);
    if (k < right.size()) at.push_back(right[k]);
  }
  return cubic_miss(x, s, at, i);
}

std::vector<bool> lone_samples(std::span<const double> x, std::span<const double> s,
                               std::span<const double> residuals,
                               const std::vector<std::size_t>& suspects, double noise) {
  // A sample that is off misses its neighbours' cubic by what it lies off the curve. Others that
  // are off beside it may hide more than half of that; with all suspects left out little is hidden.
  constexpr double kOwn = 0.5, kOwnOfAll = 0.2;
  const LoneSearch search{x, s, noise};
  std::vector<bool> is_suspect(x.size()), is_off(x.size());
  for (const std::size_t i : suspects) is_suspect[i] = true;
  for (bool again = true; again;) {
    again = false;
    for (const std::size_t i : suspects) {
      const double size = std::abs(residuals[i]);
      if (is_off[i] || search.miss(is_off, i) < kOwnOfAll * size) continue;
      if (search.miss(is_suspect, i) < kOwn * size) continue;
      is_off[i] = again = true;
    }
  }
  for (const auto& group : grouped(is_off)) search.put_back_hidden(group, is_off);
  return is_off;
}

}  // namespace camlaw::problems
