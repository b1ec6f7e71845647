// SPDX-License-Identifier: MIT
#include "fitting/motions/profile_intervals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "numerics/linear/statistics.h"

namespace camlaw::problems {
namespace {

/// The profile of one parameter to one side of its value.
class Profile {
 public:
  Profile(const optim::Residuals& residuals, const std::vector<optim::FitParameter>& parameters,
          std::size_t which, double least, double variance)
      : residuals_(residuals),
        parameters_(parameters),
        which_(which),
        least_(least),
        variance_(variance) {}

  /// Where it reaches `wanted` deviations, first looked for at `step` from the value (below 0: to
  /// the left); the bound where it does not.
  double reach(double wanted, double step) {
    constexpr int kSteps = 8;
    constexpr double kNear = 0.03, kMost = 4, kLeast = 0.25;
    const double value = parameters_[which_].start;
    const double bound = step > 0 ? parameters_[which_].upper : parameters_[which_].lower;
    double inside = 0;  // as far as it is known to be below
    std::optional<double> outside;
    for (int i = 0; i < kSteps; ++i) {
      if (std::isfinite(bound) && std::abs(step) > std::abs(bound - value)) step = bound - value;
      const double height = deviations_at(value + step);
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

 private:
  /// The square root of what the sum of squares grows by, in deviations of a residual.
  double deviations_at(double x) const {
    std::vector<optim::FitParameter> held = parameters_;
    held[which_].lower = held[which_].upper = held[which_].start = x;
    try {
      optim::FitOptions near;
      near.reach = optim::FitReach::Near;
      near.max_iterations = 50;
      const double sum = optim::fit(held, residuals_, near).sum_of_squares;
      return std::sqrt(std::max(sum - least_, 0.0) / variance_);
    } catch (const std::invalid_argument&) {  // undefined there
      return optim::kInfinity;
    }
  }

  const optim::Residuals& residuals_;
  const std::vector<optim::FitParameter>& parameters_;
  std::size_t which_;
  double least_, variance_;
};

}  // namespace

void profile_intervals(const optim::Residuals& residuals,
                       const std::vector<optim::FitParameter>& parameters, std::size_t count,
                       const std::vector<double>& inflation, double confidence,
                       optim::FitResult& fit) {
  if (!(fit.sigma > 0) || fit.degrees_of_freedom < 1) return;
  const double t = optim::student_quantile(fit.degrees_of_freedom, confidence);
  for (std::size_t j = 0; j < count; ++j) {
    optim::FittedParameter& p = fit.parameters[j];
    if (!p.identifiable || !(p.standard_deviation > 0) || !std::isfinite(p.standard_deviation)) {
      continue;
    }
    const double deviation = inflation[j] * fit.sigma;
    Profile profile(residuals, parameters, j, fit.sum_of_squares, deviation * deviation);
    p.low = profile.reach(t, -t * p.standard_deviation);
    p.high = profile.reach(t, t * p.standard_deviation);
  }
}

}  // namespace camlaw::problems
