// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

/// Small statistics around a fit. Numbers are in the unit of the values given.
namespace camlaw::optim {

/// Akaike's information criterion for small samples, to compare models fitted to the same n values
/// by least squares; less is better, constants that all models share are left out:
///   n ln(S / n) + 2 n k / (n - k - 1),  k = p + 1
/// S is the sum of squares, p the number of fitted parameters (the scatter is one more).
/// Infinite where n - p - 2 <= 0: too few values to judge the model by. Minus infinite where S is
/// zero. Source: Hurvich and Tsai 1989, Biometrika 76.
double aicc(std::size_t n, std::size_t p, double sum_of_squares);

/// Twice the negative logarithm of how likely values are under a model, whatever its parameters,
/// to compare models by; constants that all models share are left out:
///   nu ln(S / 2) - 2 ln Gamma(nu / 2) + m ln(S / nu) + ln det(1 + P C^-1),  nu = n - p
/// n values left a sum of squares S with p fitted parameters, m of which not all models have.
/// Before the values are seen these have the variances P, after they have the covariance C; `occam`
/// is the determinant's logarithm. The scatter and the other parameters may be anything (Laplace's
/// approximation; O'Hagan and Forster 2004, chapter 7). Infinite where n - p < 3: too few values to
/// judge the model by; minus infinite where S is zero.
double evidence(std::size_t n, std::size_t p, std::size_t m, double sum_of_squares, double occam);

/// The value that share q of the sorted values lies below, linear between neighbours (Hyndman and
/// Fan 1996, definition 7): q = 0 is the least, q = 1 the greatest. NaN where a value is. Throws
/// std::invalid_argument without values or for q outside [0, 1].
double quantile(std::span<const double> values, double q);
/// quantile(values, 0.5)
double median(std::span<const double> values);

/// A standard deviation that outliers hardly move: the median of |value - centre| over 0.6745, so
/// that normal values have their standard deviation. By default the centre is the median.
double median_absolute_deviation(std::span<const double> values, std::optional<double> centre = {});

/// The indexes of values from the least to the greatest.
std::vector<std::size_t> order_of(std::span<const double> values);

/// Student's t that a share of all lies within, both sides together; NaN without degrees of
/// freedom.
double student_quantile(int degrees_of_freedom, double confidence);

/// Two numbers, the first not above the second.
struct ConfidenceInterval {
  double lower, upper;
};
/// What a probability lies between of which `hits` of `count` independent trials came true (Clopper
/// and Pearson 1934): it holds at least as often as the confidence says.
ConfidenceInterval binomial_interval(double hits, double count, double confidence);
/// The same of the expectation of a sum of weights, each of an event that is rare and independent
/// of the others (Fay and Feuer 1997): `squares` is the sum of the weights' squares, `largest` what
/// no weight is above.
ConfidenceInterval weighted_poisson_interval(double sum, double squares, double largest,
                                             double confidence);

/// Student's t about a centre, as a part of a mixture; below and above the centre with a deviation
/// each.
struct StudentPart {
  double weight, centre, below, above;
  int degrees;  ///< of freedom
};

/// The value that share q of a mixture lies below; weights need not sum to 1. Throws
/// std::invalid_argument without parts or for q outside (0, 1).
double mixture_quantile(std::span<const StudentPart> parts, double q);

/// What n residuals look like along x.
struct ResidualPattern {
  /// Of neighbours: near zero for noise, near one where a model leaves a curve; 0 where all are
  /// zero.
  double correlation = 0;
  /// Squares of the means of 30 blocks of neighbours, in units of what noise makes of them, on
  /// average: near one for noise, above where a model leaves a curve that is slow and small. The
  /// noise is told by differences of neighbours. One for fewer than 120 residuals.
  double block_squares = 1;
  /// Whether they are not noise: chance makes either number as large about once in 10 000. A
  /// correlation below a tenth is passed over, however many there are: no model is that exact.
  /// Fewer than 20 residuals may look like anything.
  bool is_curve = false;
};
ResidualPattern residual_pattern(std::span<const double> x, std::span<const double> residuals);

/// The sum of squared errors of the points `left_out` under a model fitted to the points `kept`.
using FoldError = std::function<double(const std::vector<std::size_t>& kept,
                                       const std::vector<std::size_t>& left_out)>;

/// The root mean square error of prediction by cross-validation: each of the points 0 to n - 1 is
/// left out once, point i with all others of fold i mod `folds`. So neighbours fall into different
/// folds and nothing is drawn at random. NaN where a fold's error is. Throws std::invalid_argument
/// for less than two folds or more folds than points.
double cross_validated_error(std::size_t n, std::size_t folds, const FoldError& squared_error);

}  // namespace camlaw::optim
