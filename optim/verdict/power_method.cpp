// SPDX-License-Identifier: MIT
#include "optim/verdict/power_method.h"

#include <cmath>
#include <random>
#include <utility>

namespace camlaw::optim {

using Eigen::Index, Eigen::VectorXd;

namespace {

/// Each step multiplies the other eigenvectors' share by their eigenvalue over the largest.
constexpr int kMostSteps = 300;
/// The iteration ends when a step changes the eigenvalue by less than this share.
constexpr double kConverged = 1e-8;

VectorXd random_direction(Index size) {
  std::mt19937 generator(1);
  VectorXd x(size);
  for (double& xi : x) xi = std::ldexp(static_cast<double>(generator()), -31) - 1;
  return x.normalized();
}

}  // namespace

double largest_eigenvalue(Index size,
                          const std::function<VectorXd(const VectorXd& x)>& times) {
  VectorXd x = random_direction(size);
  double value = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    x = times(x);
    const double before = std::exchange(value, x.norm());
    if (!(value > 0) || std::abs(value - before) <= kConverged * value) break;
    x /= value;
  }
  return value;
}

}  // namespace camlaw::optim
