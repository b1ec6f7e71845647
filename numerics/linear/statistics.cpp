// SPDX-License-Identifier: MIT
#include "numerics/linear/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace camlaw::optim {

double aicc(std::size_t n, std::size_t p, double sum_of_squares) {
  if (n <= p + 2) return std::numeric_limits<double>::infinity();
  const auto points = static_cast<double>(n), k = static_cast<double>(p + 1);
  return points * std::log(sum_of_squares / points) + 2 * points * k / (points - k - 1);
}

namespace {

/// ln Gamma(x) for x > 0. std::lgamma tells the sign through a variable of the whole process.
double log_gamma(double x) {
  int sign = 0;
  return lgamma_r(x, &sign);
}

}  // namespace

double evidence(std::size_t n, std::size_t p, std::size_t m, double sum_of_squares, double occam) {
  if (n < p + 3) return std::numeric_limits<double>::infinity();
  const auto nu = static_cast<double>(n - p);
  return nu * std::log(sum_of_squares / 2) - 2 * log_gamma(nu / 2) +
         static_cast<double>(m) * std::log(sum_of_squares / nu) + occam;
}

double quantile(std::span<const double> values, double q) {
  if (values.empty()) throw std::invalid_argument("a quantile needs at least one value");
  if (!(q >= 0 && q <= 1)) {
    throw std::invalid_argument(fmt::format("the share {} of a quantile is not in [0, 1]", q));
  }
  std::vector<double> sorted(values.begin(), values.end());
  for (const double v : sorted) {
    if (std::isnan(v)) return v;
  }
  std::sort(sorted.begin(), sorted.end());
  const double place = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 == sorted.size() || sorted[below] == sorted[below + 1]) return sorted[below];
  return std::lerp(sorted[below], sorted[below + 1], place - static_cast<double>(below));
}

double median(std::span<const double> values) { return quantile(values, 0.5); }

double median_absolute_deviation(std::span<const double> values, std::optional<double> centre) {
  constexpr double kThirdQuartile = 0.67448975019608174;  // of the standard normal distribution
  const double middle = centre ? *centre : median(values);
  std::vector<double> distances;
  for (const double v : values) distances.push_back(std::abs(v - middle));
  return median(distances) / kThirdQuartile;
}

std::vector<std::size_t> order_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

double student_quantile(int degrees_of_freedom, double confidence) {
  if (degrees_of_freedom <= 0) return std::numeric_limits<double>::quiet_NaN();
  const boost::math::students_t_distribution<double> student(degrees_of_freedom);
  return boost::math::quantile(student, (1 + confidence) / 2);
}

namespace {

/// The share of a part below x.
double share_below(const StudentPart& part, double x) {
  const double deviation = x < part.centre ? part.below : part.above;
  if (!(deviation > 0)) return x < part.centre ? 0 : 1;
  const boost::math::students_t_distribution<double> student(part.degrees);
  return boost::math::cdf(student, (x - part.centre) / deviation);
}

}  // namespace

double mixture_quantile(std::span<const StudentPart> parts, double q) {
  if (parts.empty()) throw std::invalid_argument("a mixture needs at least one part");
  if (!(q > 0 && q < 1)) {
    throw std::invalid_argument(fmt::format("the share {} of a mixture is not in (0, 1)", q));
  }
  double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0;
  for (const StudentPart& part : parts) {
    const boost::math::students_t_distribution<double> student(part.degrees);
    const double own =
        part.centre + (q < 0.5 ? part.below : part.above) * boost::math::quantile(student, q);
    low = std::min(low, own), high = std::max(high, own);
    sum += part.weight;
  }
  constexpr int kHalvings = 60;  // more halvings than a double has bits
  for (int i = 0; i < kHalvings && low < high; ++i) {
    const double middle = std::midpoint(low, high);
    double below = 0;
    for (const StudentPart& part : parts) below += part.weight * share_below(part, middle);
    (below < q * sum ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

namespace {

double neighbour_correlation(const std::vector<double>& r) {
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    squares += r[i] * r[i];
    if (i > 0) products += r[i] * r[i - 1];
  }
  return squares > 0 ? products / squares : 0;
}

double block_squares(const std::vector<double>& r) {
  // Blocks enough that their mean square is known to a quarter; blocks of fewer than four samples
  // tell no more than the correlation of neighbours.
  constexpr std::size_t kBlocks = 30, kLeast = 4;
  const std::size_t n = r.size();
  if (n < kLeast * kBlocks) return 1;
  double differences = 0;
  for (std::size_t i = 1; i < n; ++i) differences += (r[i] - r[i - 1]) * (r[i] - r[i - 1]);
  const double variance = differences / (2 * static_cast<double>(n - 1));
  if (!(variance > 0)) return 1;
  double sum = 0;
  for (std::size_t b = 0; b < kBlocks; ++b) {
    const std::size_t begin = b * n / kBlocks, end = (b + 1) * n / kBlocks;
    double total = 0;
    for (std::size_t i = begin; i < end; ++i) total += r[i];
    sum += total * total / (static_cast<double>(end - begin) * variance);
  }
  return sum / kBlocks;
}

bool is_curve(const ResidualPattern& pattern, std::size_t n) {
  // In fewer residuals noise alone has a correlation of kMost in one record of 80 or more often.
  constexpr std::size_t kEnough = 20;
  // Noise passes 3.7 deviations once in 10 000 records. A correlation of a half counts however few
  // samples there are, one of less than a tenth never does.
  constexpr double kDeviations = 3.7, kMost = 0.5, kLeast = 0.1;
  constexpr double kSquares = 2.3;  // chi-square of 30 over 30 at 1e-4
  if (n < kEnough) return false;
  const double alike = std::clamp(kDeviations / std::sqrt(static_cast<double>(n)), kLeast, kMost);
  return pattern.correlation > alike ||
         (pattern.correlation > 0 && pattern.block_squares > kSquares);
}

}  // namespace

ResidualPattern residual_pattern(std::span<const double> x, std::span<const double> residuals) {
  std::vector<double> r;
  for (const std::size_t i : order_of(x)) r.push_back(residuals[i]);
  ResidualPattern pattern{neighbour_correlation(r), block_squares(r)};
  pattern.is_curve = is_curve(pattern, r.size());
  return pattern;
}

double cross_validated_error(std::size_t n, std::size_t folds, const FoldError& squared_error) {
  if (folds < 2 || folds > n) {
    throw std::invalid_argument(
        fmt::format("{} folds of {} points: from 2 to as many as points are possible", folds, n));
  }
  double sum = 0;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    std::vector<std::size_t> kept, left_out;
    for (std::size_t i = 0; i < n; ++i) (i % folds == fold ? left_out : kept).push_back(i);
    sum += squared_error(kept, left_out);
  }
  return std::sqrt(sum / static_cast<double>(n));
}

ConfidenceInterval binomial_interval(double hits, double count, double confidence) {
  using boost::math::beta_distribution;
  const double tail = (1 - confidence) / 2;
  const double others = count - hits;
  return {hits > 0 ? boost::math::quantile(beta_distribution<double>(hits, others + 1), tail) : 0,
          others > 0 ? boost::math::quantile(beta_distribution<double>(hits + 1, others), 1 - tail)
                     : 1};
}

ConfidenceInterval weighted_poisson_interval(double sum, double squares, double largest,
                                             double confidence) {
  const double tail = (1 - confidence) / 2;
  // A gamma distribution with this mean and this variance.
  const auto at = [](double mean, double variance, double share) {
    const boost::math::gamma_distribution<double> gamma(mean * mean / variance, variance / mean);
    return boost::math::quantile(gamma, share);
  };
  return {sum > 0 ? at(sum, squares, tail) : 0,
          at(sum + largest, squares + largest * largest, 1 - tail)};
}

}  // namespace camlaw::optim
