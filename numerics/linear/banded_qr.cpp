// SPDX-License-Identifier: MIT
#include "numerics/linear/banded_qr.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camlaw::optim {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

namespace {

std::size_t first_column(const RowMatrix& A, int row) {
  return static_cast<std::size_t>(A.innerIndexPtr()[A.outerIndexPtr()[row]]);
}

std::size_t end_column(const RowMatrix& A, int row) {
  return static_cast<std::size_t>(A.innerIndexPtr()[A.outerIndexPtr()[row + 1] - 1]) + 1;
}

/// Rows without entries are left out.
std::vector<int> rows_by_first_column(const RowMatrix& A) {
  std::vector<int> order;
  for (int i = 0; i < A.rows(); ++i) {
    if (A.outerIndexPtr()[i] < A.outerIndexPtr()[i + 1]) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](int i, int k) { return first_column(A, i) < first_column(A, k); });
  return order;
}

/// Of entries of columns whose lengths are near one. std::hypot takes ten times as long, and is
/// needed only where squares underflow.
double length_of(double x, double y) {
  constexpr double kSafe = 1e-280;  // below it the smaller square loses digits at 1e-308
  const double square = x * x + y * y;
  return square > kSafe ? std::sqrt(square) : std::hypot(x, y);
}

}  // namespace

BandedQr::BandedQr(const RowMatrix& A, double tolerance)
    : dependent_(static_cast<std::size_t>(A.cols()), false), carried_(dependent_.size(), 0.0) {
  const std::vector<int> order = rows_by_first_column(A);
  reserve(A, order);
  auto next = order.begin();
  for (std::size_t j = 0; j < dependent_.size(); ++j) {
    for (; next != order.end() && first_column(A, *next) == j; ++next) {
      for (RowMatrix::InnerIterator it(A, *next); it; ++it) {
        carried_[static_cast<std::size_t>(it.col())] = it.value();
      }
      carried_end_ = end_column(A, *next);
      carry(static_cast<std::size_t>(*next), false, j);
    }
    if (ends_[j] == j || std::abs(*row(j)) <= tolerance) take_out(j);
  }
}

/// A row of R reaches no further than any row of A that starts before it ends or at it.
void BandedQr::reserve(const RowMatrix& A, const std::vector<int>& order) {
  std::size_t size = 0, reach = 0;
  auto next = order.begin();
  for (std::size_t j = 0; j < dependent_.size(); ++j) {
    for (; next != order.end() && first_column(A, *next) == j; ++next) {
      reach = std::max(reach, end_column(A, *next));
    }
    offsets_.push_back(size);
    ends_.push_back(j);
    size += std::max(reach, j) - j;
  }
  values_.assign(size, 0.0);
}

void BandedQr::carry(std::size_t row, bool from_r, std::size_t first) {
  for (std::size_t j = first; j < carried_end_; ++j) {
    if (carried_[j] != 0) rotate(j);
  }
  journeys_.push_back({row, from_r, rotations_.size()});
}

void BandedQr::rotate(std::size_t column) {
  double* r = row(column);
  double* c = carried_.data() + column;
  const double length = length_of(*r, *c);
  const double cosine = *r / length, sine = *c / length;
  ends_[column] = std::max(ends_[column], carried_end_);
  const std::size_t count = ends_[column] - column;
  for (std::size_t i = 0; i < count; ++i) {
    const double above = r[i], below = c[i];
    r[i] = cosine * above + sine * below;
    c[i] = cosine * below - sine * above;
  }
  *c = 0;
  carried_end_ = ends_[column];
  rotations_.push_back({column, cosine, sine});
}

void BandedQr::take_out(std::size_t column) {
  dependent_[column] = true;
  if (ends_[column] == column) return;
  double* r = row(column);
  carried_end_ = ends_[column];
  std::copy(r + 1, r + (carried_end_ - column), carried_.begin() + static_cast<long>(column) + 1);
  ends_[column] = column;
  carry(column, true, column + 1);
}

Eigen::VectorXd BandedQr::rotated(const Eigen::VectorXd& target) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(dependent_.size()));
  std::size_t k = 0;
  for (const Journey& journey : journeys_) {
    double t = journey.from_r ? std::exchange(y[journey.row], 0.0) : target[journey.row];
    for (; k < journey.end; ++k) {
      const auto& [column, cosine, sine] = rotations_[k];
      const double above = y[column];
      y[column] = cosine * above + sine * t;
      t = cosine * t - sine * above;
    }
  }
  return y;
}

Eigen::VectorXd BandedQr::solve(const Eigen::VectorXd& y) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(y.size());
  for (std::size_t j = dependent_.size(); j-- > 0;) {
    if (dependent_[j]) continue;
    double rest = y[j];
    for (std::size_t i = j + 1; i < ends_[j]; ++i) rest -= row(j)[i - j] * x[i];
    x[j] = rest / *row(j);
  }
  return x;
}

Eigen::VectorXd BandedQr::solve_transposed(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = x;
  for (std::size_t j = 0; j < dependent_.size(); ++j) {
    y[j] = dependent_[j] ? 0 : y[j] / *row(j);
    for (std::size_t i = j + 1; i < ends_[j]; ++i) y[i] -= row(j)[i - j] * y[j];
  }
  return y;
}

Eigen::VectorXd BandedQr::times(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  for (std::size_t j = 0; j < dependent_.size(); ++j) {
    for (std::size_t i = j; i < ends_[j]; ++i) y[j] += row(j)[i - j] * x[i];
  }
  return y;
}

Eigen::VectorXd BandedQr::transposed_times(const Eigen::VectorXd& y) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(y.size());
  for (std::size_t j = 0; j < dependent_.size(); ++j) {
    for (std::size_t i = j; i < ends_[j]; ++i) x[i] += row(j)[i - j] * y[j];
  }
  return x;
}

}  // namespace camlaw::optim
