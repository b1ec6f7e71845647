// SPDX-License-Identifier: MIT
#include "numerics/spline/smoothing_spline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "numerics/spline/smoothing_fit.h"

namespace camlaw::optim {
namespace {

Impossible no_spline(const std::string& why) { return {"smoothing spline: " + why}; }

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument(no_spline(why).why);
}

void check_options(const SmoothingOptions& options) {
  if (options.penalty < 1 || options.penalty > options.degree) {
    refuse(fmt::format("the penalty's order {} is not from 1 to the degree {}", options.penalty,
                       options.degree));
  }
  if (options.mu && !(*options.mu > 0 && std::isfinite(*options.mu))) {
    refuse(fmt::format("mu = {:.6g} is not above 0", *options.mu));
  }
  if (!(options.caution >= 1)) refuse(fmt::format("caution {:.6g} is below 1", options.caution));
  if (options.spans && *options.spans < 1) {
    refuse(fmt::format("{} spans are too few", *options.spans));
  }
  if (!options.knots.empty() && options.spans) refuse("both knots and spans are given");
  if (!(options.outlier_chance > 0 && options.outlier_chance < 1)) {
    refuse(fmt::format("the chance of outliers, {:.6g}, is not between 0 and 1",
                       options.outlier_chance));
  }
}

Possible<std::vector<SplineSample>> checked_samples(std::span<const double> x,
                                                    std::span<const double> y,
                                                    std::span<const double> weights) {
  if (x.size() != y.size() || (!weights.empty() && weights.size() != x.size())) {
    return no_spline(fmt::format("{} places, {} values and {} weights do not belong together",
                                 x.size(), y.size(), weights.size()));
  }
  std::vector<SplineSample> samples;
  samples.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double weight = weights.empty() ? 1 : weights[i];
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
      return no_spline(fmt::format("sample {} is not finite: x = {}, y = {}", i, x[i], y[i]));
    }
    if (!(weight > 0 && std::isfinite(weight))) {
      return no_spline(fmt::format("the weight of sample {} is {}, not above 0", i, weight));
    }
    samples.push_back({x[i], y[i], weight, i});
  }
  if (samples.empty()) return no_spline("there are no samples");
  return samples;
}

Possible<std::vector<double>> places_of(const SmoothingOptions& options,
                                        const std::vector<SplineSample>& samples) {
  if (options.periodic && !options.range) refuse("a periodic one needs a range, its period");
  const auto [low, high] = std::minmax_element(
      samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [begin, end] = options.range.value_or(std::pair(low->x, high->x));
  if (!(begin < end) || !std::isfinite(end - begin)) {
    return no_spline(fmt::format("its range, {:.6g} to {:.6g}, is empty", begin, end));
  }
  if (low->x < begin || high->x > end) {
    return no_spline(fmt::format("sample {} at {:.6g} lies outside {:.6g} to {:.6g}",
                                 low->x < begin ? low->index : high->index,
                                 low->x < begin ? low->x : high->x, begin, end));
  }
  std::vector<double> places{begin};
  if (options.knots.empty()) {
    const int least = options.periodic ? options.degree + 1 : 1;
    const int half = static_cast<int>(std::min<std::size_t>(samples.size() / 2, 1000));
    const int spans = options.spans.value_or(std::max(half, least));
    for (int i = 1; i < spans; ++i) places.push_back(begin + (end - begin) * i / spans);
  }
  places.insert(places.end(), options.knots.begin(), options.knots.end());
  places.push_back(end);
  return places;
}

/// Fewer different places than m + 1 leave a polynomial that nothing holds, or nothing to smooth.
std::optional<Impossible> too_few_places(std::vector<SplineSample>& samples, int penalty) {
  std::sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) {
    return std::tie(a.x, a.index) < std::tie(b.x, b.index);
  });
  int different = 1;
  for (std::size_t i = 1; i < samples.size(); ++i) different += samples[i].x > samples[i - 1].x;
  if (different < penalty + 1) {
    return no_spline(
        fmt::format("samples at {} different places are too few, a penalty of order {} needs {}",
                    different, penalty, penalty + 1));
  }
  return {};
}

/// Factors that pick out one derivative. Those above the degree are all 0.
std::span<const double> unit_of(int order) {
  static constexpr auto kUnits = [] {
    std::array<double, 2 * kMostDegree + 3> units{};
    units[kMostDegree + 1] = 1;
    return units;
  }();
  const auto kept = static_cast<std::size_t>(std::clamp(order, 0, kMostDegree + 1));
  return std::span(kUnits).subspan(kMostDegree + 1 - kept, kept + 1);
}

/// The row of sum over k of factors[k] s^(k)(x).
SplineBasis::Row combined_row(const SplineBasis& basis, double x, std::span<const double> factors) {
  const std::size_t span = basis.span_at(x);
  SplineBasis::Row sum{span, {}};
  for (std::size_t order = 0; order < factors.size(); ++order) {
    if (factors[order] == 0) continue;
    const auto row = basis.row_in(span, x, static_cast<int>(order));
    for (std::size_t k = 0; k < sum.values.size(); ++k) {
      sum.values[k] += factors[order] * row.values[k];
    }
  }
  return sum;
}

}  // namespace

double SmoothingSpline::operator()(double x, int order) const {
  return combination(x, unit_of(order));
}

double SmoothingSpline::combination(double x, std::span<const double> factors) const {
  const double at = fit_.basis.inside(x);
  if (std::isnan(at)) return at;
  return fit_.basis.value(combined_row(fit_.basis, at, factors), fit_.coefficients);
}

double SmoothingSpline::standard_error(double x, int order) const {
  return standard_error(x, unit_of(order));
}

double SmoothingSpline::standard_error(double x, std::span<const double> factors) const {
  const double at = fit_.basis.inside(x);
  if (std::isnan(at)) return at;
  const auto equation = fit_.unknowns.equation(combined_row(fit_.basis, at, factors), 0, 1);
  return fit_.sigma * std::sqrt(std::max(fit_.inverse->form(equation), 0.0));
}

Possible<SmoothingSpline> possible_smoothing_spline(std::span<const double> x,
                                                    std::span<const double> y,
                                                    const SmoothingOptions& options,
                                                    std::span<const double> weights) {
  check_options(options);
  auto samples = checked_samples(x, y, weights);
  if (!samples) return samples.reason();
  if (auto why = too_few_places(*samples, options.penalty)) return std::move(*why);
  const auto places = places_of(options, *samples);
  if (!places) return places.reason();
  if (auto why = SplineBasis::fault(options.degree, *places, options.periodic)) {
    return std::move(*why);
  }
  const SplineBasis basis(options.degree, *places, options.periodic);
  auto fit = smoothed(basis, std::move(*samples), options);
  if (!fit) return fit.reason();
  return SmoothingSpline(std::move(*fit));
}

SmoothingSpline smoothing_spline(std::span<const double> x, std::span<const double> y,
                                 const SmoothingOptions& options, std::span<const double> weights) {
  return possible_smoothing_spline(x, y, options, weights).value();
}

}  // namespace camlaw::optim
