// SPDX-License-Identifier: MIT
#include "fitting/motions/rounding_errors.h"

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/motion_residuals.h"
#include "optim/fit/eigen_matrix.h"
#include "optim/fit/fit_report.h"

namespace camlaw::problems {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int kWaves = 40;  // of the saw-tooth: what is left is a fortieth of its squares

/// The variance of a wave of the rounding error of values with noise of this variance.
double variance_of_wave(int k, double step, double noise) {
  const double frequency = std::numbers::pi * k / step;
  return std::exp(-4 * frequency * frequency * noise) / (2 * frequency * frequency);
}

}  // namespace

double least_sum_of_squares(const MotionSamples& samples) {
  constexpr double kRounding = 1e-10;
  double size = 0;
  for (const double y : samples.value) size = std::max(size, std::abs(y));
  const double floor = std::max(kRounding * size, rounding_deviation(samples));
  return static_cast<double>(samples.value.size()) * floor * floor;
}

std::vector<double> count_rounding(const MotionSamples& samples, const optim::Residuals& residuals,
                                   const std::vector<optim::FitParameter>& given, double confidence,
                                   optim::FitResult& fit) {
  const double step = samples.resolution;
  std::vector<double> grown(fit.parameters.size(), 1);
  if (step <= 0 || !(fit.sigma > 0) || !std::isfinite(fit.sigma)) return grown;
  const auto n = static_cast<Index>(residuals.count());
  const auto m = static_cast<Index>(fit.parameters.size());
  const std::vector<double> p = values_of(fit);
  Jacobian jacobian(n, m);
  VectorXd r(n);
  if (!residuals.evaluate(p, {r.data(), static_cast<std::size_t>(n)},
                          {jacobian.data(), static_cast<std::size_t>(n * m)})) {
    return grown;
  }
  const double rounding = rounding_deviation(samples) * rounding_deviation(samples);
  const double all = std::max(fit.sigma * fit.sigma, rounding), noise = all - rounding;
  const auto is_upper = [&](Index i) {  // the derivative by the stroke is the law
    return samples.order == 0 && jacobian(i, MotionLayout::kStroke) > 0.5;
  };
  double alone = all;
  MatrixXd squares = MatrixXd::Zero(m, m);
  for (int k = 1; k <= kWaves; ++k) {
    const double variance = variance_of_wave(k, step, noise);
    if (variance < 1e-6 * rounding) break;
    // Of the levels of the two rests it is not known how they lie to each other within a step: the
    // halves of a motion are counted apart.
    for (const bool upper : {false, true}) {
      VectorXd cosines = VectorXd::Zero(m), sines = VectorXd::Zero(m);
      for (Index i = 0; i < n; ++i) {
        if (upper != is_upper(i)) continue;
        const double curve = samples.value[static_cast<std::size_t>(i)] + r[i];
        const double phase = 2 * std::numbers::pi * k * (curve / step);
        cosines += std::cos(phase) * jacobian.row(i).transpose();
        sines += std::sin(phase) * jacobian.row(i).transpose();
      }
      squares += variance * (cosines * cosines.transpose() + sines * sines.transpose());
    }
    alone -= variance;
  }
  squares += alone * (jacobian.transpose() * jacobian);
  // Of parameters that are not determined nothing is known; the others have no part of them.
  const MatrixXd inverse = optim::as_eigen(fit.covariance) / (fit.sigma * fit.sigma);
  const MatrixXd known = inverse.unaryExpr([](double x) { return std::isfinite(x) ? x : 0; });
  // What else than the samples' values is known of a parameter, as where they jump, has its own
  // part.
  const MatrixXd by_values = known * squares * known;
  const MatrixXd own = known - known * (jacobian.transpose() * jacobian) * known;
  MatrixXd covariance = by_values + fit.sigma * fit.sigma * own;
  covariance.diagonal() = covariance.diagonal().cwiseMax(by_values.diagonal());  // but for rounding
  auto stated = optim::as_eigen(fit.covariance);
  for (Index i = 0; i < m; ++i) {
    const double before = stated(i, i);
    if (std::isfinite(before) && before > 0) {
      grown[static_cast<std::size_t>(i)] = std::sqrt(covariance(i, i) / before);
    }
  }
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < m; ++j) {
      if (std::isfinite(stated(i, j))) stated(i, j) = covariance(i, j);
    }
  }
  optim::set_intervals(given, confidence, fit);
  return grown;
}

}  // namespace camlaw::problems
