// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "numerics/linear/banded_split.h"
#include "numerics/linear/bordered_qr.h"
#include "numerics/linear/column_factors.h"
#include "numerics/linear/power_method.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Columns = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

class SparseFactors : public ColumnFactors {
 public:
  SparseFactors(std::shared_ptr<const BandedSplit> split, const std::vector<int>& columns)
      : split_(std::move(split)), order_(in_band(*split_, columns)), qr_(factor(columns)) {
    for (std::size_t k = 0; k < order_.size(); ++k) dependent_[order_[k]] = qr_.dependent()[k];
  }

  VectorXd solve(const VectorXd& target) const override {
    VectorXd dense(split_->dense.rows());
    for (Index i = 0; i < dense.size(); ++i) {
      dense[i] = target[split_->dense_rows[static_cast<std::size_t>(i)]];
    }
    const VectorXd ordered = qr_.solve(target, dense);
    VectorXd x(ordered.size());
    for (std::size_t k = 0; k < order_.size(); ++k) {
      x[static_cast<Index>(order_[k])] = ordered[static_cast<Index>(k)];
    }
    return x;
  }

  const std::vector<bool>& dependent() const override { return dependent_; }

  double condition() const override {
    const bool any = std::find(dependent_.begin(), dependent_.end(), true) != dependent_.end();
    if (any) return std::numeric_limits<double>::infinity();
    return condition_of(qr_.largest_singular_value(), qr_.least_singular_value());
  }

 private:
  /// Numbers among the given columns, in the band's order: by counting, since a sort of thousands
  /// takes as long as their rotations.
  static std::vector<std::size_t> in_band(const BandedSplit& split,
                                          const std::vector<int>& columns) {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> at_place(split.places.size(), kNone);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      at_place[static_cast<std::size_t>(split.places[static_cast<std::size_t>(columns[k])])] = k;
    }
    std::erase(at_place, kNone);
    return at_place;
  }

  BorderedQr factor(const std::vector<int>& columns) {
    dependent_.resize(columns.size());
    const auto count = static_cast<Index>(columns.size());
    Columns S(split_->banded.rows(), count);
    Eigen::VectorXi entries(count);
    for (Index k = 0; k < count; ++k) entries[k] = entry_count(columns[order_[k]]);
    S.reserve(entries);
    MatrixXd D(split_->dense.rows(), count);
    for (Index k = 0; k < count; ++k) {
      const int column = columns[order_[static_cast<std::size_t>(k)]];
      for (Columns::InnerIterator it(split_->banded, column); it; ++it) {
        S.insert(it.row(), k) = it.value();
      }
      D.col(k) = split_->dense.col(column);
    }
    return BorderedQr(Rows(S), D, kDependent);
  }

  int entry_count(int column) const {
    return split_->banded.outerIndexPtr()[column + 1] - split_->banded.outerIndexPtr()[column];
  }

  std::shared_ptr<const BandedSplit> split_;
  std::vector<std::size_t> order_;  ///< place in the band -> number among the given columns
  std::vector<bool> dependent_;
  BorderedQr qr_;
};

FactorColumns factors(BandedSplit split) {
  return [shared = std::make_shared<const BandedSplit>(std::move(split))](
             const std::vector<int>& columns) {
    return std::make_unique<SparseFactors>(shared, columns);
  };
}

}  // namespace

FactorColumns sparse_factors(const Columns& A) { return factors(banded_split(A)); }

FactorColumns cheaper_factors(const Columns& A) {
  const auto rows = static_cast<double>(A.rows()), columns = static_cast<double>(A.cols());
  const double dense_work = rows * columns * std::min(rows, columns);
  // A dense factorization of 200 columns takes some milliseconds: pivoting is worth that.
  if (dense_work < 1e7) return dense_factors(A);
  BandedSplit parts = banded_split(A);
  // A rotation costs some four times a dense update, entry by entry.
  if (4 * rotated_entries(parts) > dense_work) return dense_factors(A);
  return factors(std::move(parts));
}

}  // namespace camlaw::optim
