// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fitting/motions/coefficients.h"
#include "optim/fit/least_squares.h"
#include "optim/fit/residuals.h"

/// What the coefficients of a law must meet together, for fits: bounds of each say too little
/// (docs/optimisation.md, "Fits to samples").
namespace camlaw::problems {

/// (FS5) The part of 1 that coefficients leave, 1 - sum factors[i] q[i]: not below 0, or none.
struct LawLimit {
  std::vector<double> factors;  ///< of coefficients_of(law)
  std::string name;             ///< of what is left, "1 - 4 ramp - 2 constant"
  bool is_equal = false;        ///< nothing may be left
};

/// Phases that must fit in the law's length, harmonics that must make its stroke; none for laws
/// whose coefficients are free of one another.
std::optional<LawLimit> limit_of(const Member& law);

/// Whether it is what zero shift and stroke of a motion stand for: the law's own end values.
bool is_end_value(const Member& law, const Coefficient& coefficient);

/// Residuals in which what is left stands for one of the coefficients, so that the limit is a bound
/// of its own.
class LimitedResiduals final : public optim::ResidualsOf {
 public:
  /// `residuals` have the coefficients from the parameter `first`. The one that takes up most of
  /// the limit at `start` is replaced. Keeps a reference to the residuals.
  LimitedResiduals(const optim::Residuals& residuals, LawLimit limit, std::size_t first,
                   std::span<const double> start);

  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override;

  /// The coefficient in the place of what is left.
  std::vector<double> given(std::span<const double> p) const;
  /// The parameters with what is left in the place of the coefficient.
  std::vector<optim::FitParameter> limited(std::vector<optim::FitParameter> parameters) const;
  /// A fit of those, told of the coefficients: values, covariance and intervals of all of them.
  optim::FitResult of_coefficients(optim::FitResult fit,
                                   const std::vector<optim::FitParameter>& parameters,
                                   double confidence) const;

 private:
  /// The replaced coefficient.
  double coefficient(std::span<const double> p) const;

  LawLimit limit_;
  std::size_t first_, replaced_;
};

}  // namespace camlaw::problems
