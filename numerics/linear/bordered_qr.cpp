// SPDX-License-Identifier: MIT
#include "numerics/linear/bordered_qr.h"

#include <cmath>
#include <utility>

#include "numerics/linear/power_method.h"

namespace camlaw::optim {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

BorderedQr::BorderedQr(const Eigen::SparseMatrix<double, Eigen::RowMajor>& S, const MatrixXd& D,
                       double tolerance)
    : qr_(S, tolerance), D_(D), W_(D.cols(), D.rows()), dependent_(qr_.dependent()) {
  for (Index i = 0; i < D.rows(); ++i) W_.col(i) = qr_.solve_transposed(D.row(i).transpose());
  std::vector<Index> spare;
  for (Index j = 0; j < D.cols(); ++j) {
    if (dependent_[static_cast<std::size_t>(j)]) spare.push_back(j);
  }
  factor_border(spare, tolerance);
  factor_update();
}

void BorderedQr::factor_border(const std::vector<Index>& spare, double tolerance) {
  const Index rows = D_.rows(), columns = static_cast<Index>(spare.size());
  Q_ = MatrixXd::Identity(rows, rows);
  if (rows == 0 || columns == 0) return;
  MatrixXd E(rows, columns);
  for (Index i = 0; i < rows; ++i) {
    const VectorXd product = qr_.transposed_times(W_.col(i));
    for (Index k = 0; k < columns; ++k) {
      const double own = D_(i, spare[k]), spanned = product[spare[k]];
      E(i, k) = own - spanned;
    }
  }
  // What the subtraction leaves of equal numbers is rounding.
  for (Index k = 0; k < columns; ++k) {
    if (E.col(k).norm() <= tolerance * D_.col(spare[k]).norm()) E.col(k).setZero();
  }
  const PivotedQr qr = pivoted_qr(E, tolerance);
  Q_ = qr.factors.orthogonal();
  T_ = qr.factors.packed.topLeftCorner(qr.rank, qr.rank).triangularView<Eigen::Upper>();
  for (Index i = 0; i < qr.rank; ++i) {
    chosen_.push_back(spare[qr.columns[static_cast<std::size_t>(i)]]);
    dependent_[static_cast<std::size_t>(chosen_.back())] = false;
  }
}

void BorderedQr::factor_update() {
  const Index columns = W_.rows(), rest = Q_.cols() - T_.cols();
  if (rest == 0) return;
  G_ = W_ * Q_.rightCols(rest);
  MatrixXd stacked(columns + rest, rest);
  stacked << G_, MatrixXd::Identity(rest, rest);
  update_ = householder_qr(stacked);
}

VectorXd BorderedQr::solve(const VectorXd& target_S, const VectorXd& target_D) const {
  return solve(Image{qr_.rotated(target_S), target_D});
}

VectorXd BorderedQr::solve(const Image& target) const {
  const Index met = T_.cols(), rest = Q_.cols() - met;
  const VectorXd open = Q_.transpose() * (target.D - W_.transpose() * target.R);
  VectorXd y = target.R;
  VectorXd x = VectorXd::Zero(W_.rows());
  if (rest > 0) {
    // The shortest (u, v) with G^T u + v = what is open: v stays open.
    VectorXd u = VectorXd::Zero(W_.rows() + rest);
    const auto R = update_.packed.topRows(rest).triangularView<Eigen::Upper>();
    u.head(rest) = R.transpose().solve(open.tail(rest));
    u = update_.times(std::move(u));
    y += u.head(W_.rows());
  }
  if (met > 0) {
    const VectorXd due = Q_.leftCols(met).transpose() * (target.D - W_.transpose() * y);
    const VectorXd values = T_.triangularView<Eigen::Upper>().solve(due);
    for (Index i = 0; i < met; ++i) x[chosen_[static_cast<std::size_t>(i)]] = values[i];
    y -= qr_.times(x);
  }
  return x + qr_.solve(y);
}

/// The shortest vector whose products with C's independent columns are x.
BorderedQr::Image BorderedQr::solve_transposed(const VectorXd& x) const {
  const Index met = T_.cols(), rest = Q_.cols() - met;
  Image image{qr_.solve_transposed(x), VectorXd::Zero(Q_.cols())};
  if (met > 0) {
    const VectorXd product = qr_.transposed_times(image.R);
    VectorXd open(met);
    for (Index i = 0; i < met; ++i) {
      const Index j = chosen_[static_cast<std::size_t>(i)];
      open[i] = x[j] - product[j];
    }
    image.D = Q_.leftCols(met) * T_.triangularView<Eigen::Upper>().transpose().solve(open);
    image.R -= W_ * image.D;
  }
  if (rest > 0) {
    VectorXd stacked = VectorXd::Zero(W_.rows() + rest);
    stacked.head(W_.rows()) = image.R;
    const VectorXd values = update_.solve(stacked);
    image.R -= G_ * values;
    image.D += Q_.rightCols(rest) * values;
  }
  return image;
}

double BorderedQr::largest_singular_value() const {
  return std::sqrt(largest_eigenvalue(W_.rows(), [this](const VectorXd& x) {
    return VectorXd(qr_.transposed_times(qr_.times(x)) + D_.transpose() * (D_ * x));
  }));
}

double BorderedQr::least_singular_value() const {
  return 1 / std::sqrt(largest_eigenvalue(
                 W_.rows(), [this](const VectorXd& x) { return solve(solve_transposed(x)); }));
}

}  // namespace camlaw::optim
