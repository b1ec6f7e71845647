// SPDX-License-Identifier: MIT
#include "fitting/motions/rounding_errors.h"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>

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

/// The variances of the waves of the rounding error of values with noise of this variance; few or
/// none where noise is as large as the step, so that errors are independent.
std::vector<double> variances_of_waves(double step, double noise, double rounding) {
  constexpr double kLeast = 1e-6;  // of that of rounding
  std::vector<double> result;
  for (int k = 1; k <= kWaves; ++k) {
    const double frequency = std::numbers::pi * k / step;
    const double variance =
        std::exp(-4 * frequency * frequency * noise) / (2 * frequency * frequency);
    if (variance < kLeast * rounding) break;
    result.push_back(variance);
  }
  return result;
}

/// Residuals and their Jacobian at a fit.
struct Linearised {
  VectorXd r;
  Jacobian jacobian;
};

std::optional<Linearised> linearised(const optim::Residuals& residuals,
                                     const std::vector<double>& p) {
  const auto n = static_cast<Index>(residuals.count()), m = static_cast<Index>(p.size());
  Linearised result{VectorXd(n), Jacobian(n, m)};
  if (!residuals.evaluate(p, {result.r.data(), static_cast<std::size_t>(n)},
                          {result.jacobian.data(), static_cast<std::size_t>(n * m)})) {
    return {};
  }
  return result;
}

/// Adds what the waves make of the parameters' pulls.
void add_waves(const MotionSamples& samples, const Linearised& all,
               const std::vector<double>& variances, MatrixXd& squares) {
  const Index m = all.jacobian.cols();
  const auto count = static_cast<Index>(variances.size());
  // Of the levels of the two rests it is not known how they lie to each other within a step: the
  // halves of a motion are counted apart.
  for (const bool upper : {false, true}) {
    MatrixXd cosines = MatrixXd::Zero(m, count), sines = MatrixXd::Zero(m, count);
    for (Index i = 0; i < all.r.size(); ++i) {
      // The derivative by the stroke is the law.
      const bool is_upper = samples.order == 0 && all.jacobian(i, MotionLayout::kStroke) > 0.5;
      if (upper != is_upper) continue;
      const double curve = samples.value[static_cast<std::size_t>(i)] + all.r[i];
      const std::complex<double> turn =
          std::polar(1.0, 2 * std::numbers::pi * std::remainder(curve / samples.resolution, 1.0));
      std::complex<double> wave = 1;
      for (Index k = 0; k < count; ++k) {
        wave *= turn;
        cosines.col(k) += wave.real() * all.jacobian.row(i).transpose();
        sines.col(k) += wave.imag() * all.jacobian.row(i).transpose();
      }
    }
    for (Index k = 0; k < count; ++k) {
      squares +=
          variances[static_cast<std::size_t>(k)] *
          (cosines.col(k) * cosines.col(k).transpose() + sines.col(k) * sines.col(k).transpose());
    }
  }
}

}  // namespace

double least_sum_of_squares(const MotionSamples& samples) {
  constexpr double kRounding = 1e-10;  // of the values: a sum below it is the fit's own rounding
  double size = 0;
  for (const double y : samples.value) size = std::max(size, std::abs(y));
  const double floor = std::max(kRounding * size, rounding_deviation(samples));
  return static_cast<double>(samples.value.size()) * floor * floor;
}

std::vector<double> count_rounding(const MotionSamples& samples, const optim::Residuals& residuals,
                                   const optim::Residuals& all,
                                   const std::vector<optim::FitParameter>& given, double confidence,
                                   optim::FitResult& fit) {
  const double step = samples.resolution;
  std::vector<double> grown(fit.parameters.size(), 1);
  if (step <= 0 || !(fit.sigma > 0) || !std::isfinite(fit.sigma)) return grown;
  const auto m = static_cast<Index>(fit.parameters.size());
  const std::vector<double> p = values_of(fit);
  const auto told = linearised(residuals, p);
  if (!told) return grown;
  const double rounding = rounding_deviation(samples) * rounding_deviation(samples);
  const double whole = std::max(fit.sigma * fit.sigma, rounding);
  const std::vector<double> variances = variances_of_waves(step, whole - rounding, rounding);
  const double alone = std::accumulate(variances.begin(), variances.end(), whole, std::minus<>());
  const MatrixXd information = told->jacobian.transpose() * told->jacobian;
  MatrixXd squares = alone * information;
  if (!variances.empty()) {
    const auto waves = &residuals == &all ? told : linearised(all, p);
    if (!waves) return grown;
    add_waves(samples, *waves, variances, squares);
  }
  // Of parameters that are not determined nothing is known; the others have no part of them.
  const MatrixXd inverse = optim::as_eigen(fit.covariance) / (fit.sigma * fit.sigma);
  const MatrixXd known = inverse.unaryExpr([](double x) { return std::isfinite(x) ? x : 0; });
  // What else than the samples' values is known of a parameter, as where they jump, has its own
  // part.
  const MatrixXd by_values = known * squares * known;
  const MatrixXd own = known - known * information * known;
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
