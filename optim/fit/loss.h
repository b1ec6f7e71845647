// SPDX-License-Identifier: MIT
#pragma once

#include "optim/fit/least_squares.h"
#include "optim/fit/residuals.h"

/// Losses: how much a large residual counts.
namespace camlaw::optim {

/// A loss at one residual, with rho near r^2 for small r.
struct LossAt {
  double rho = 0;
  double weight = 1;  ///< rho' / (2 r), 1 at r = 0: what the residual counts in least squares
  double pull = 0;    ///< psi = rho' / 2 = weight r
  double slope = 1;   ///< psi'
};

LossAt loss_at(Loss loss, double scale, double r);

/// The scale, as a multiple of the residuals' standard deviation, with which a fit to normal errors
/// is 95 % as efficient as least squares (Huber 1.345, Cauchy 2.385: Holland and Welsch 1977).
double efficient_scale(Loss loss);

/// sign(r) sqrt(rho(r)): residuals whose sum of squares is the sum of the losses. Numbers that are
/// not finite count as undefined. Counts the evaluations.
class LossResiduals final : public ResidualsOf {
 public:
  LossResiduals(const Residuals& residuals, Loss loss, double scale)
      : ResidualsOf(residuals), loss_(loss), scale_(scale) {}

  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override;
  int evaluations() const { return evaluations_; }

 private:
  Loss loss_;
  double scale_;
  mutable int evaluations_ = 0;
};

}  // namespace camlaw::optim
