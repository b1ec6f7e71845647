// SPDX-License-Identifier: MIT
#include "numerics/linear/banded_lu.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camlaw::optim {

using Eigen::Index;

BandedLu::BandedLu(Index size, Index half)
    : size_(size),
      half_(half),
      width_(3 * half + 1),
      multipliers_(static_cast<std::size_t>(size * half)),
      pivots_(static_cast<std::size_t>(size)) {}

bool BandedLu::factor(const std::vector<double>& entries) {
  entries_ = entries;
  return eliminate();
}

bool BandedLu::factor(std::vector<double>&& entries) {
  entries_ = std::move(entries);
  return eliminate();
}

bool BandedLu::eliminate() {
  for (Index k = 0; k < size_; ++k) {
    const Index below = std::min(half_, size_ - 1 - k), right = std::min(2 * half_, size_ - 1 - k);
    const auto in_column = [&](Index i) { return std::abs(row(i)[k - i]); };
    Index pivot = k;
    for (Index i = k + 1; i <= k + below; ++i) {
      if (in_column(i) > in_column(pivot)) pivot = i;
    }
    pivots_[static_cast<std::size_t>(k)] = pivot;
    if (!(in_column(pivot) > 0)) return false;
    double* const top = row(k);
    if (pivot != k) std::swap_ranges(top, top + right + 1, row(pivot) + (k - pivot));
    for (Index i = 1; i <= below; ++i) {
      double* const other = row(k + i) - i;
      const double multiplier = other[0] / top[0];
      multipliers_[static_cast<std::size_t>(k * half_ + i - 1)] = multiplier;
      if (multiplier == 0) continue;
      for (Index j = 1; j <= right; ++j) other[j] -= multiplier * top[j];
    }
  }
  return true;
}

Eigen::VectorXd BandedLu::solve(Eigen::VectorXd b) const {
  for (Index k = 0; k < size_; ++k) {
    std::swap(b[k], b[pivots_[static_cast<std::size_t>(k)]]);
    const Index below = std::min(half_, size_ - 1 - k);
    const double* const multipliers = multipliers_.data() + k * half_;
    for (Index i = 1; i <= below; ++i) b[k + i] -= multipliers[i - 1] * b[k];
  }
  for (Index k = size_ - 1; k >= 0; --k) {
    const Index right = std::min(2 * half_, size_ - 1 - k);
    const double* const top = row(k);
    double left = b[k];
    // The nearest last: what is before it waits for no unknown that has just been found.
    for (Index j = right; j >= 1; --j) left -= top[j] * b[k + j];
    b[k] = left / top[0];
  }
  return b;
}

}  // namespace camlaw::optim
