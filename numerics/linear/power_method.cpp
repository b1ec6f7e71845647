// SPDX-License-Identifier: MIT
#include "numerics/linear/power_method.h"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace camlaw::optim {

using Eigen::Index, Eigen::VectorXd;

namespace {

/// Each step multiplies the other eigenvectors' share by their eigenvalue over the largest.
constexpr int kMostSteps = 200;
/// The iteration ends when a step changes the eigenvalue by less than this share.
constexpr double kConverged = 1e-10;

VectorXd random_direction(Index size) {
  std::mt19937 generator(1);
  VectorXd x(size);
  for (double& xi : x) xi = std::ldexp(static_cast<double>(generator()), -31) - 1;
  return x.normalized();
}

}  // namespace

double largest_eigenvalue(Index size, const std::function<VectorXd(const VectorXd& x)>& times) {
  VectorXd x = random_direction(size);
  double value = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    x = times(x);
    const double before = std::exchange(value, x.stableNorm());
    if (!(value > 0) || std::abs(value - before) <= kConverged * value) break;
    x /= value;
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
