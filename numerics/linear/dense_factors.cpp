// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "numerics/linear/column_factors.h"
#include "numerics/linear/dense.h"
#include "numerics/linear/power_method.h"

namespace camlaw::optim {
namespace {

class DenseFactors : public ColumnFactors {
 public:
  explicit DenseFactors(const Eigen::MatrixXd& C)
      : qr_(pivoted_qr(C, kDependent)), dependent_(count(C.cols()), true) {
    for (Eigen::Index i = 0; i < qr_.rank; ++i) dependent_[count(column(i))] = false;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& target) const override {
    const Eigen::Index rank = qr_.rank;
    const Eigen::VectorXd y = qr_.factors.transposed_times(target);
    const auto R = qr_.factors.packed.topLeftCorner(rank, rank).triangularView<Eigen::Upper>();
    const Eigen::VectorXd pivoted = R.solve(y.head(rank));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(columns());
    for (Eigen::Index i = 0; i < rank; ++i) x[column(i)] = pivoted[i];
    return x;
  }

  const std::vector<bool>& dependent() const override { return dependent_; }

  double condition() const override {
    const Eigen::Index n = columns();
    if (qr_.rank < n) return std::numeric_limits<double>::infinity();
    const auto R = qr_.factors.packed.topRows(n).triangularView<Eigen::Upper>();
    const double largest = largest_eigenvalue(n, [&](const Eigen::VectorXd& x) {
      return Eigen::VectorXd(R.transpose() * Eigen::VectorXd(R * x));
    });
    const double inverse = largest_eigenvalue(n, [&](const Eigen::VectorXd& x) {
      return Eigen::VectorXd(R.solve(Eigen::VectorXd(R.transpose().solve(x))));
    });
    return condition_of(std::sqrt(largest), 1 / std::sqrt(inverse));
  }

 private:
  static std::size_t count(Eigen::Index i) { return static_cast<std::size_t>(i); }
  Eigen::Index column(Eigen::Index pivot) const { return qr_.columns[count(pivot)]; }
  Eigen::Index columns() const { return qr_.factors.packed.cols(); }

  PivotedQr qr_;
  std::vector<bool> dependent_;
};

}  // namespace

FactorColumns dense_factors(const Eigen::SparseMatrix<double>& A) {
  return [&A](const std::vector<int>& columns) {
    Eigen::MatrixXd C(A.rows(), columns.size());
    for (std::size_t j = 0; j < columns.size(); ++j) C.col(j) = A.col(columns[j]);
    return std::make_unique<DenseFactors>(C);
  };
}

}  // namespace camlaw::optim
