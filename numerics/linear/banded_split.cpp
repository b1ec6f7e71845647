// SPDX-License-Identifier: MIT
#include "numerics/linear/banded_split.h"

#include <algorithm>

#include "numerics/linear/band_order.h"

namespace camlaw::optim {

using Eigen::Index;
using Eigen::MatrixXd;
using Columns = Eigen::SparseMatrix<double>;

namespace {

/// More dense rows than these are not worth setting apart.
constexpr std::size_t kMostDenseRows = 64;

/// Rows with far more entries than a row has on average, the fullest first.
std::vector<Index> dense_rows(const Columns& A) {
  std::vector<Index> count(static_cast<std::size_t>(A.rows()), 0), rows;
  for (Index k = 0; k < A.nonZeros(); ++k) ++count[static_cast<std::size_t>(A.innerIndexPtr()[k])];
  const Index many = std::max<Index>(32, 4 * A.nonZeros() / std::max<Index>(1, A.rows()));
  for (Index i = 0; i < A.rows(); ++i) {
    if (count[static_cast<std::size_t>(i)] > many) rows.push_back(i);
  }
  std::stable_sort(rows.begin(), rows.end(), [&](Index i, Index k) {
    return count[static_cast<std::size_t>(i)] > count[static_cast<std::size_t>(k)];
  });
  if (rows.size() > kMostDenseRows) rows.resize(kMostDenseRows);
  return rows;
}

}  // namespace

BandedSplit banded_split(const Columns& A) {
  BandedSplit s;
  s.dense_rows = dense_rows(A);
  s.dense = MatrixXd::Zero(static_cast<Index>(s.dense_rows.size()), A.cols());
  std::vector<Index> dense_row(static_cast<std::size_t>(A.rows()), -1);
  for (std::size_t k = 0; k < s.dense_rows.size(); ++k) {
    dense_row[static_cast<std::size_t>(s.dense_rows[k])] = static_cast<Index>(k);
  }
  s.banded = A;
  s.banded.prune([&](Index row, Index column, double value) {
    const Index k = dense_row[static_cast<std::size_t>(row)];
    if (k >= 0) s.dense(k, column) = value;
    return k < 0;
  });
  s.places.resize(static_cast<std::size_t>(A.cols()));
  const std::vector<int> order = band_order(s.banded);
  for (std::size_t k = 0; k < order.size(); ++k) {
    s.places[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  }
  return s;
}

double rotated_entries(const BandedSplit& split) {
  std::vector<int> first(static_cast<std::size_t>(split.banded.rows()),
                         static_cast<int>(split.banded.cols()));
  std::vector<int> last(first.size(), -1);
  for (Index j = 0; j < split.banded.cols(); ++j) {
    const int place = split.places[static_cast<std::size_t>(j)];
    for (Columns::InnerIterator it(split.banded, j); it; ++it) {
      int& low = first[static_cast<std::size_t>(it.row())];
      int& high = last[static_cast<std::size_t>(it.row())];
      low = std::min(low, place);
      high = std::max(high, place);
    }
  }
  double sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double width = std::max(0, last[i] - first[i] + 1);
    sum += width * width;
  }
  return sum;
}

}  // namespace camlaw::optim
