// SPDX-License-Identifier: MIT
#include "numerics/linear/band_order.h"

#include <algorithm>
#include <utility>

namespace camlaw::optim {
namespace {

class Walk {
 public:
  explicit Walk(const Eigen::SparseMatrix<double>& A)
      : columns_(A), rows_(A), column_seen_(A.cols(), 0), row_seen_(A.rows(), 0) {}

  /// All columns that `start` is connected with, by distance; those of few entries first.
  std::vector<int> from(int start) {
    ++walk_;
    std::vector<int> found{start};
    column_seen_[start] = walk_;
    for (std::size_t k = 0; k < found.size(); ++k) {
      const std::size_t known = found.size();
      for (Columns::InnerIterator it(columns_, found[k]); it; ++it) add_row(it.row(), found);
      std::stable_sort(found.begin() + static_cast<long>(known), found.end(),
                       [&](int a, int b) { return entries(a) < entries(b); });
    }
    return found;
  }

  bool seen(int column) const { return column_seen_[column] != 0; }

 private:
  using Columns = Eigen::SparseMatrix<double>;
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  void add_row(Eigen::Index row, std::vector<int>& found) {
    if (std::exchange(row_seen_[row], walk_) == walk_) return;
    for (Rows::InnerIterator it(rows_, row); it; ++it) {
      if (std::exchange(column_seen_[it.col()], walk_) == walk_) continue;
      found.push_back(static_cast<int>(it.col()));
    }
  }

  int entries(int column) const {
    return columns_.outerIndexPtr()[column + 1] - columns_.outerIndexPtr()[column];
  }

  Columns columns_;
  Rows rows_;
  std::vector<int> column_seen_, row_seen_;  ///< the last walk that passed
  int walk_ = 0;
};

}  // namespace

std::vector<int> band_order(const Eigen::SparseMatrix<double>& A) {
  std::vector<int> order;
  Walk walk(A);
  for (int j = 0; j < A.cols(); ++j) {
    if (walk.seen(j)) continue;
    // The column furthest from any other lies at an end; from there the band is narrowest.
    const std::vector<int> part = walk.from(walk.from(j).back());
    order.insert(order.end(), part.begin(), part.end());
  }
  return order;
}

}  // namespace camlaw::optim
