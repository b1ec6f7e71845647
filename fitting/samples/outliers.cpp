// SPDX-License-Identifier: MIT
#include "fitting/samples/outliers.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <stdexcept>

#include "numerics/linear/statistics.h"

namespace camlaw::problems {
namespace {

/// The larger of the lower quartiles of the five neighbours' sizes on each side.
double beside(const std::vector<double>& sizes, std::size_t i) {
  // (FS4): five on each side, of which the quartile passes one or two other outliers.
  constexpr std::size_t kReach = 5;
  const std::size_t begin = i > kReach ? i - kReach : 0;
  const std::size_t end = std::min(i + kReach + 1, sizes.size());
  double most = 0;
  const std::span all(sizes);
  for (const auto side : {all.subspan(begin, i - begin), all.subspan(i + 1, end - i - 1)}) {
    if (!side.empty()) most = std::max(most, optim::quantile(side, 0.25));
  }
  return most;
}

}  // namespace

Outliers find_outliers(std::span<const double> place, std::span<const double> residual,
                       std::size_t parameters, double least, double chance) {
  if (place.size() != residual.size()) {
    throw std::invalid_argument("outliers: there must be as many residuals as abscissas");
  }
  constexpr double kBeside = 5;  // (FS4): where a law is wrong, neighbours lie off as well
  const std::size_t count = residual.size();
  Outliers result;
  constexpr std::size_t kFreedom = 10;  // fewer do not tell their deviation
  if (count < parameters + kFreedom) return result;
  const auto n = static_cast<double>(count);
  const double rest = static_cast<double>(count - parameters);
  result.deviation = optim::median_absolute_deviation(residual, 0.0) * std::sqrt(n / rest);
  const double z =
      boost::math::quantile(boost::math::complement(boost::math::normal(), chance / (2 * n)));
  result.bound = std::max(z * result.deviation, least);
  const std::vector<std::size_t> order = optim::order_of(place);
  std::vector<double> sizes;
  for (const std::size_t i : order) sizes.push_back(std::abs(residual[i]));
  for (std::size_t i = 0; i < count; ++i) {
    if (sizes[i] > result.bound && sizes[i] > kBeside * beside(sizes, i)) {
      result.samples.push_back(order[i]);
    }
  }
  std::sort(result.samples.begin(), result.samples.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(residual[a]) > std::abs(residual[b]);
  });
  return result;
}

bool draws(const Outliers& found, std::span<const double> residual) {
  constexpr double kDrawn = 0.1;  // of the sum of squares: less hardly pulls a fit
  double squares = 0, all = 0;
  for (const double r : residual) all += r * r;
  for (const std::size_t i : found.samples) squares += residual[i] * residual[i];
  return squares > kDrawn * all;
}

}  // namespace camlaw::problems
