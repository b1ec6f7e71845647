// SPDX-License-Identifier: MIT
#include "fitting/motions/occam.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "fitting/motions/fit_parameters.h"
#include "numerics/linear/dense.h"
#include "optim/fit/eigen_matrix.h"

namespace camlaw::problems {

Occam occam_of(const optim::Residuals& residuals,
               const std::vector<optim::FitParameter>& parameters, std::size_t first, double size,
               double deviation, const optim::FitResult& fit) {
  using Eigen::Index;
  constexpr double kMost = 0.1;
  const std::size_t m = parameters.size(), n = residuals.count();
  // Where a coefficient has no effect to first order it has one to second order, as a rule: a
  // polynomial's where it changes as begin and end do. The samples then leave it the square root of
  // what they else would.
  const double most = kMost * size / deviation;
  const double second = 0.5 * std::log1p(static_cast<double>(n) * most * most / 12);
  std::vector<Index> own;
  bool has_open = false;
  for (std::size_t j = first; j < m; ++j) {
    if (is_held(parameters[j]) || fit.parameters[j].at_bound) continue;
    if (fit.parameters[j].identifiable) {
      own.push_back(static_cast<Index>(j));
    } else {
      has_open = true;
    }
  }
  Occam result{own.size(), has_open ? second * static_cast<double>(fit.free_directions.size()) : 0};
  const std::vector<double> p = values_of(fit);
  std::vector<double> r(n), jacobian(n * m);
  if (own.empty() || !residuals.evaluate(p, r, jacobian)) return result;
  Eigen::VectorXd before(static_cast<Index>(own.size()));
  for (std::size_t k = 0; k < own.size(); ++k) {
    const auto j = static_cast<std::size_t>(own[k]);
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) squares += jacobian[i * m + j] * jacobian[i * m + j];
    const double effect = std::sqrt(squares / static_cast<double>(n));
    const double range = std::min(parameters[j].upper - parameters[j].lower, kMost * size / effect);
    before[static_cast<Index>(k)] = range / std::sqrt(12.0);
  }
  // Of the covariance in units of what was known before: its eigenvalues, one by one.
  const double larger = std::max(1.0, deviation / fit.sigma);
  const Eigen::VectorXd scale = before.cwiseInverse() * larger;
  const Eigen::MatrixXd known = scale.asDiagonal() *
                                Eigen::MatrixXd(optim::as_eigen(fit.covariance)(own, own)) *
                                scale.asDiagonal();
  if (!known.allFinite()) return result;
  constexpr double kLeast = 1e-30;
  for (const double value : optim::symmetric_eigen(known).values) {
    result.logarithm += std::max(std::log1p(1 / std::max(value, kLeast)), second);
  }
  return result;
}

}  // namespace camlaw::problems
