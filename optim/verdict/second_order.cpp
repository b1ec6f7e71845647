// SPDX-License-Identifier: MIT
#include "optim/verdict/second_order.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Adds factor * second derivatives of a function, by typical changes.
void add_hessian(const SecondOrderPoint& point, const Function& f, double factor, Triplets& H) {
  if (factor == 0 || f.shape() == Shape::Linear) return;
  const auto& inputs = f.inputs();
  std::vector<double> g(inputs.size()), h(packed_size(inputs.size()));
  f.hessian(point.x, g, h);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t j = 0; j < inputs.size(); ++j) {
      const int row = point.layout.row[inputs[i]], column = point.layout.row[inputs[j]];
      const double second = h[packed(std::max(i, j), std::min(i, j))];
      if (row < 0 || column < 0 || second == 0) continue;
      H.emplace_back(
          row, column,
          factor * second * point.sizes.variables[inputs[i]] * point.sizes.variables[inputs[j]]);
    }
  }
}

/// A peak's place moves with the design: d(place)/dx = -g_xa / g_aa, which adds
/// g_xa g_xa^T / |g_aa| to the peak's second derivatives.
void add_peak_motion(const SecondOrderPoint& point, const ActiveLimit& limit, double multiplier,
                     Triplets& H) {
  const double curvature = limit.sign * limit.curvature;
  if (limit.slope_gradient.empty() || multiplier == 0 || !(curvature < 0)) return;
  std::vector<std::pair<int, double>> slopes;
  for (std::size_t i = 0; i < limit.slope_gradient.size(); ++i) {
    const double slope = limit.slope_gradient[i] * point.sizes.variables[i];
    if (slope != 0 && point.layout.row[i] >= 0) slopes.emplace_back(point.layout.row[i], slope);
  }
  for (const auto& [row, a] : slopes) {
    for (const auto& [column, b] : slopes) {
      H.emplace_back(row, column, multiplier * a * b / (-curvature * limit.size));
    }
  }
}

/// Gradients of the limits that hold the design: those that push, and those that are met exactly.
Eigen::SparseMatrix<double> held(const SecondOrderPoint& point,
                                 const std::vector<ActiveLimit>& limits,
                                 const std::vector<double>& multipliers) {
  constexpr double kPushes = 1e-8, kMet = 1e-7;
  Triplets entries;
  int column = 0;
  for (std::size_t j = 0; j < limits.size(); ++j) {
    if (std::abs(multipliers[j]) <= kPushes && limits[j].margin > kMet) continue;
    for (const auto& [variable, slope] : limits[j].gradient) {
      if (point.layout.row[variable] >= 0)
        entries.emplace_back(point.layout.row[variable], column, slope);
    }
    if (limits[j].auxiliary != 0) {
      entries.emplace_back(point.layout.auxiliary, column, limits[j].auxiliary);
    }
    ++column;
  }
  Eigen::SparseMatrix<double> A(point.layout.rows, column);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

constexpr double kNegative = 1e-6;  // of the largest second derivative

bool dense_test(const Eigen::MatrixXd& H, const Eigen::MatrixXd& A) {
  Eigen::MatrixXd reduced = H;
  if (A.cols() > 0) {
    Eigen::FullPivHouseholderQR<Eigen::MatrixXd> qr(A);
    qr.setThreshold(1e-10);
    const Eigen::Index free = H.rows() - qr.rank();
    if (free == 0) return true;
    const Eigen::MatrixXd Q = qr.matrixQ();
    const Eigen::MatrixXd N = Q.rightCols(free);
    reduced = N.transpose() * H * N;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(reduced, Eigen::EigenvaluesOnly);
  return eigen.eigenvalues().minCoeff() >= -kNegative * H.cwiseAbs().maxCoeff();
}

/// Finsler: H is positive along the null space of A^T where H + rho A A^T is positive for some rho.
bool sparse_test(const Eigen::SparseMatrix<double>& H, const Eigen::SparseMatrix<double>& A) {
  double largest = 0;
  for (int k = 0; k < H.outerSize(); ++k) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(H, k); entry; ++entry) {
      largest = std::max(largest, std::abs(entry.value()));
    }
  }
  if (largest == 0) return true;
  Eigen::SparseMatrix<double> identity(H.rows(), H.cols());
  identity.setIdentity();
  const Eigen::SparseMatrix<double> outer = A * A.transpose();
  for (const double rho : {1e2, 1e5, 1e8}) {
    const Eigen::SparseMatrix<double> sum =
        H + (rho * largest) * outer + (kNegative * largest) * identity;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(sum);
    if (factors.info() == Eigen::Success && factors.vectorD().minCoeff() > 0) return true;
  }
  return false;
}

}  // namespace

Eigen::SparseMatrix<double> lagrangian_hessian(const SecondOrderPoint& point,
                                               const std::vector<ActiveLimit>& limits,
                                               const std::vector<double>& multipliers) {
  Triplets entries;
  const Objective& objective = point.problem.objective;
  if (point.layout.auxiliary < 0) {
    const double sign = objective.sense == Sense::Minimize ? 1 : -1;
    add_hessian(point, objective.response.function(), sign / point.sizes.objective, entries);
  }
  for (std::size_t j = 0; j < limits.size(); ++j) {
    if (!limits[j].function) continue;
    const double factor = multipliers[j] * limits[j].sign / limits[j].size;
    add_hessian(point, *limits[j].function, factor, entries);
    add_peak_motion(point, limits[j], multipliers[j], entries);
  }
  Eigen::SparseMatrix<double> H(point.layout.rows, point.layout.rows);
  H.setFromTriplets(entries.begin(), entries.end());
  return H;
}

bool second_order_holds(const SecondOrderPoint& point, const std::vector<ActiveLimit>& limits,
                        const std::vector<double>& multipliers) {
  constexpr int kDense = 300;
  if (point.layout.rows == 0) return true;
  const auto H = lagrangian_hessian(point, limits, multipliers);
  const auto A = held(point, limits, multipliers);
  if (H.nonZeros() == 0) return true;
  if (point.layout.rows <= kDense) return dense_test(H, A);
  return sparse_test(H, A);
}

}  // namespace camlaw::optim
