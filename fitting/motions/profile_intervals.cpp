// SPDX-License-Identifier: MIT
#include "fitting/motions/profile_intervals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "numerics/linear/statistics.h"

namespace camlaw::problems {
namespace {

/// Where the profile of a parameter, `deviations` as a function of its value, reaches `wanted`,
/// first looked for at `step` from where it starts (below 0: to the left); the bound where it does
/// not.
double reach(const optim::FitParameter& parameter, const std::function<double(double)>& deviations,
             double wanted, double step) {
  // With steps in proportion three are enough where residuals bend little.
  constexpr int kSteps = 8;
  // Two digits of an interval are shown. Where residuals bend, a step in proportion may be off by
  // as much as four times.
  constexpr double kNear = 0.03, kMost = 4, kLeast = 0.25;
  const double value = parameter.start, bound = step > 0 ? parameter.upper : parameter.lower;
  double inside = 0;  // as far as it is known to be below
  std::optional<double> outside;
  for (int i = 0; i < kSteps; ++i) {
    if (std::isfinite(bound) && std::abs(step) > std::abs(bound - value)) step = bound - value;
    const double height = deviations(value + step);
    if (std::abs(height - wanted) < kNear * wanted) return value + step;
    (height < wanted ? inside : outside.emplace(step)) = step;
    if (height < wanted && value + step == bound) return bound;
    // Deviations go with the step where residuals are linear.
    double next = step * std::clamp(height > 0 ? wanted / height : kMost, kLeast, kMost);
    const double far = outside.value_or(kMost * next);
    if (std::abs(next) <= std::abs(inside) || std::abs(next) >= std::abs(far)) {
      next = (inside + far) / 2;
    }
    step = next;
  }
  return value + outside.value_or(inside);
}

/// The sum of squares where the parameters start.
double squares_at_start(const optim::Residuals& residuals,
                        const std::vector<optim::FitParameter>& parameters) {
  std::vector<double> p, r(residuals.count());
  for (const auto& parameter : parameters) p.push_back(parameter.start);
  if (!residuals.evaluate(p, r, {})) return optim::kInfinity;
  return std::inner_product(r.begin(), r.end(), r.begin(), residuals.rest());
}

/// The least sum of squares with one parameter held at x.
double squares_at(const optim::Residuals& residuals, std::vector<optim::FitParameter> parameters,
                  std::size_t which, double x, const std::atomic<bool>* stop) {
  parameters[which].lower = parameters[which].upper = parameters[which].start = x;
  optim::FitOptions near;
  near.reach = optim::FitReach::Near;
  near.max_iterations = 50;
  near.stop = stop;
  const auto fit = optim::possible_fit(parameters, residuals, near);
  return fit ? fit->sum_of_squares : optim::kInfinity;
}

}  // namespace

void profile_intervals(const optim::Residuals& residuals,
                       const std::vector<optim::FitParameter>& parameters, std::size_t count,
                       const std::vector<double>& inflation, double confidence,
                       const std::atomic<bool>* stop, optim::FitResult& fit) {
  if (!(fit.sigma > 0) || fit.degrees_of_freedom < 1) return;
  const double least = squares_at_start(residuals, parameters);
  const double t = optim::student_quantile(fit.degrees_of_freedom, confidence);
  for (std::size_t j = 0; j < count; ++j) {
    optim::FittedParameter& p = fit.parameters[j];
    if (!p.identifiable || !(p.standard_deviation > 0) || !std::isfinite(p.standard_deviation)) {
      continue;
    }
    const double deviation = inflation[j] * fit.sigma, variance = deviation * deviation;
    const auto deviations = [&](double x) {
      const double more = squares_at(residuals, parameters, j, x, stop) - least;
      return std::sqrt(std::max(more, 0.0) / variance);
    };
    p.low = reach(parameters[j], deviations, t, -t * p.standard_deviation);
    p.high = reach(parameters[j], deviations, t, t * p.standard_deviation);
  }
}

}  // namespace camlaw::problems
