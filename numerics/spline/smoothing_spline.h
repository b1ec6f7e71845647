// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "numerics/spline/spline_basis.h"
#include "numerics/spline/spline_unknowns.h"

/// Smooth curves through noisy samples (docs/theory.md, "Smoothing splines").
namespace camlaw::optim {

/// How mu is chosen where it is not given.
enum class SmoothingChoice {
  GeneralisedCrossValidation,  ///< (O6), Craven and Wahba 1979
  LeaveOneOut                  ///< (O7); looks at every sample for each mu tried
};

/// How samples that lie far off lose their weight (O9): Huber's bounds their pull, Tukey's bisquare
/// lets the far ones go altogether.
enum class Reweighting { None, Huber, Bisquare };

struct SmoothingOptions {
  int degree = 5;   ///< p of the spline
  int penalty = 3;  ///< m, order of the derivative that is kept small: 1 to p
  bool periodic = false;
  /// Where it begins and ends, one period if periodic; none: at the outer samples.
  std::optional<std::pair<double, double>> range = {};
  /// Inner knots, increasing; none: even ones.
  std::vector<double> knots = {};
  /// How many spans even knots make; none: half as many as samples, at most 1000.
  std::optional<int> spans = {};
  EndCondition begin = {}, end = {};
  std::optional<double> mu = {};  ///< none: chosen
  SmoothingChoice choice = SmoothingChoice::GeneralisedCrossValidation;
  /// What degrees of freedom count in (O6). 1 is the classical criterion; 1.4 guards against the
  /// few samples in which it hardly smooths at all (Kim and Gu 2004).
  double caution = 1;
  Reweighting reweighting = Reweighting::None;
  /// Deviation of a sample that reweighting takes them to have at least: of rounding, or what is
  /// too little to matter.
  double least_noise = 0;
  /// Chance that any sample at all is flagged where all are good.
  double outlier_chance = 0.05;
};

/// What became of one sample.
struct SmoothedSample {
  double residual;     ///< y - s(x)
  double leverage;     ///< h, how much s(x) follows y: ds(x) / dy
  double kept;         ///< of its weight after re-weighting, 0 to 1
  double studentised;  ///< (O8) residual over its deviation, the sample itself left out
  bool outlying;       ///< beyond what chance explains, after Bonferroni
};

/// What a fit has found.
struct SmoothedFit {
  SplineBasis basis;
  SplineUnknowns unknowns;
  std::vector<double> coefficients = {};
  std::shared_ptr<const BandInverse> inverse = {};
  double mu = 0, degrees_of_freedom = 0;
  double squares = 0;  ///< of the samples, weighed
  double sigma = 0, outlier_bound = 0;
  std::vector<SmoothedSample> samples = {};
};

/// The spline s that makes sum w (y - s(x))^2 + mu * integral of (s^(m))^2 least. Derivatives are
/// those of the spline, exactly. s and y have the samples' unit, mu that of w x^(2m - 1).
class SmoothingSpline {
 public:
  explicit SmoothingSpline(SmoothedFit fit) : fit_(std::move(fit)) {}

  /// The order-th derivative; NaN outside the range of a spline that is not periodic.
  double operator()(double x, int order = 0) const;
  /// sum over k of factors[k] s^(k)(x).
  double combination(double x, std::span<const double> factors) const;

  /// Standard error of the order-th derivative: the posterior deviation under the prior for which
  /// s is the mean (Wahba 1983), sigma sqrt(b^T (B^T W B + mu Omega)^-1 b). On the average over the
  /// samples it covers noise and bias together; 0 where an end condition fixes the value.
  double standard_error(double x, int order = 0) const;
  /// The same of sum over k of factors[k] s^(k)(x).
  double standard_error(double x, std::span<const double> factors) const;

  const SplineBasis& basis() const { return fit_.basis; }
  /// One for each function of the basis.
  const std::vector<double>& coefficients() const { return fit_.coefficients; }
  double mu() const { return fit_.mu; }
  /// Trace of the matrix that takes y to s(x).
  double degrees_of_freedom() const { return fit_.degrees_of_freedom; }
  /// sigma: deviation of a sample of weight 1. From the sum of squares, or with re-weighting from
  /// the median of the residuals.
  double residual_deviation() const { return fit_.sigma; }
  /// One for each sample, in the order given.
  const std::vector<SmoothedSample>& samples() const { return fit_.samples; }
  /// The studentised residual beyond which a sample is flagged.
  double outlier_bound() const { return fit_.outlier_bound; }

 private:
  SmoothedFit fit_;
};

/// Fits samples y at x, in any order and spacing; a weight is 1 / variance up to a factor, none
/// given: all are 1. Time and memory grow linearly with the samples. Impossible: lengths that
/// differ, values that are not finite, weights that are not above 0, x outside the range, samples
/// at fewer than m + 1 different places, and too few for the conditions at the ends. Throws
/// std::invalid_argument for options that are not such.
Possible<SmoothingSpline> possible_smoothing_spline(std::span<const double> x,
                                                    std::span<const double> y,
                                                    const SmoothingOptions& options = {},
                                                    std::span<const double> weights = {});
/// The same; throws std::invalid_argument where it is impossible.
SmoothingSpline smoothing_spline(std::span<const double> x, std::span<const double> y,
                                 const SmoothingOptions& options = {},
                                 std::span<const double> weights = {});

}  // namespace camlaw::optim
