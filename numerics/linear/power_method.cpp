// SPDX-License-Identifier: MIT
#include "numerics/linear/power_method.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace camlaw::optim {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr Index kMostSteps = 100;
/// The iteration ends when a step changes the eigenvalue by less than this share.
constexpr double kConverged = 1e-10;

VectorXd random_direction(Index size) {
  std::mt19937 generator(1);
  VectorXd x(size);
  for (double& xi : x) xi = std::ldexp(static_cast<double>(generator()), -31) - 1;
  return x.normalized();
}

/// Of the symmetric matrix with this diagonal and these entries beside it.
double largest_of(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  const auto size = static_cast<Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen;
  eigen.computeFromTridiagonal(Eigen::Map<const VectorXd>(diagonal.data(), size),
                               Eigen::Map<const VectorXd>(beside.data(), size - 1),
                               Eigen::EigenvaluesOnly);
  return eigen.eigenvalues()[size - 1];
}

}  // namespace

double largest_eigenvalue(Index size, const std::function<VectorXd(const VectorXd& x)>& times) {
  const Index most = std::min(kMostSteps, size);
  Eigen::MatrixXd basis(size, 0);
  std::vector<double> diagonal, beside;
  VectorXd x = random_direction(size);
  double value = 0;
  while (basis.cols() < most) {
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = x;
    x = times(x);
    if (!x.allFinite()) return x.stableNorm();
    diagonal.push_back(basis.rightCols(1).col(0).dot(x));
    for (int time = 0; time < 2; ++time) x -= basis * (basis.transpose() * x);
    const double before = std::exchange(value, largest_of(diagonal, beside));
    const double length = x.stableNorm();
    if (std::abs(value - before) <= kConverged * value || !(length > 0)) break;
    beside.push_back(length);
    x /= length;
  }
  return value;
}

double condition_of(double largest, double least) {
  const double ratio = largest / least;
  return ratio < 1 / std::numeric_limits<double>::epsilon()
             ? ratio
             : std::numeric_limits<double>::infinity();
}

}  // namespace camlaw::optim
