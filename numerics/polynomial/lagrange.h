// SPDX-License-Identifier: MIT
#pragma once

#include <span>

/// Polynomials through some of a list of samples, by Lagrange.
namespace camlaw {

/// The weight of the k-th sample, one of those `at`, in the polynomial's value at the i-th.
inline double lagrange_weight(std::span<const double> x, std::span<const std::size_t> at,
                              std::size_t k, std::size_t i) {
  double weight = 1;
  for (const std::size_t l : at) {
    if (l != k) weight *= (x[i] - x[l]) / (x[k] - x[l]);
  }
  return weight;
}

/// By how much the i-th sample misses the polynomial through those `at`.
inline double lagrange_miss(std::span<const double> x, std::span<const double> s,
                            std::span<const std::size_t> at, std::size_t i) {
  double miss = s[i];
  for (const std::size_t k : at) miss -= lagrange_weight(x, at, k, i) * s[k];
  return miss;
}

}  // namespace camlaw
