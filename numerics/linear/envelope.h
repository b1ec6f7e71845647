// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "numerics/scalar/scalar.h"

namespace camlaw {

/// A symmetric, positive definite system A x = b in any scalar. Of each row of the lower triangle
/// the part from its first entry to the diagonal is kept, which factors fill and never leave.
template <class T>
class Envelope {
 public:
  explicit Envelope(std::size_t size) : rows_(size), right_(size, number<T>(0)) {
    for (std::size_t i = 0; i < size; ++i) rows_[i] = {i, {number<T>(0)}};
  }

  /// Adds to A[i][k] and A[k][i].
  void add(std::size_t i, std::size_t k, const T& value) {
    if (i < k) std::swap(i, k);
    Row& row = rows_[i];
    if (k < row.first) {
      row.entries.insert(row.entries.begin(), row.first - k, number<T>(0));
      row.first = k;
    }
    T& entry = row.entries[k - row.first];
    entry = entry + value;
  }
  /// Adds to b[i].
  void add_right(std::size_t i, const T& value) { right_[i] = right_[i] + value; }

  /// x, by A = L D L^T, without pivots. The matrix is used up.
  std::vector<T> solve() && {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i) factor_row(i);
    std::vector<T> x = std::move(right_);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = rows_[i].first; k < i; ++k) x[i] = x[i] - at(i, k) * x[k];
    }
    for (std::size_t i = 0; i < n; ++i) x[i] = x[i] / at(i, i);
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = rows_[i].first; k < i; ++k) x[k] = x[k] - at(i, k) * x[i];
    }
    return x;
  }

 private:
  struct Row {
    std::size_t first;
    std::vector<T> entries;
  };

  T& at(std::size_t i, std::size_t k) { return rows_[i].entries[k - rows_[i].first]; }

  /// Row i of L and D, from those before it.
  void factor_row(std::size_t i) {
    for (std::size_t k = rows_[i].first; k < i; ++k) {
      // L_ik D_k, of which the sum holds L_im D_m from the steps before.
      for (std::size_t m = std::max(rows_[i].first, rows_[k].first); m < k; ++m) {
        at(i, k) = at(i, k) - at(i, m) * at(k, m);
      }
    }
    for (std::size_t k = rows_[i].first; k < i; ++k) {
      const T scaled = at(i, k);
      at(i, k) = scaled / at(k, k);
      at(i, i) = at(i, i) - at(i, k) * scaled;
    }
  }

  std::vector<Row> rows_;
  std::vector<T> right_;
};

}  // namespace camlaw
