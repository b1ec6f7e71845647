// SPDX-License-Identifier: MIT
#include "problems/fits/drift.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "problems/fits/motion_residuals.h"

namespace camlaw::problems {

Drift drift_of(const MotionSamples& samples, const LawFit& fit) {
  using Eigen::Index;
  const MotionResiduals residuals(samples, fit.law, fit.skew);
  const auto n = static_cast<Index>(residuals.count());
  const auto m = static_cast<Index>(fit.fit.parameters.size());
  if (samples.order != 0 || n < m + 3) return {};
  std::vector<double> p;
  for (const auto& parameter : fit.fit.parameters) p.push_back(parameter.value);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(n, m);
  Eigen::VectorXd r(n);
  if (!residuals.evaluate(p, {r.data(), static_cast<std::size_t>(n)},
                          {jacobian.data(), static_cast<std::size_t>(n * m)})) {
    return {};
  }
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  Eigen::VectorXd slope(n);
  for (Index i = 0; i < n; ++i) {
    slope[i] = (samples.place[static_cast<std::size_t>(i)] - *low) / (*high - *low);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> law(jacobian);
  slope -= jacobian * law.solve(slope).eval();
  r -= jacobian * law.solve(r).eval();
  const double squares = slope.squaredNorm();
  constexpr double kLeast = 1e-6;  // else the law follows a slope itself
  if (!(squares > kLeast * static_cast<double>(n))) return {};
  const double drift = -slope.dot(r) / squares;  // residuals are law less samples
  const double left = (r + drift * slope).squaredNorm();
  const double deviation = std::sqrt(left / static_cast<double>(n - m - 1) / squares);
  return {drift, deviation > 0 ? std::abs(drift) / deviation : 0};
}

}  // namespace camlaw::problems
