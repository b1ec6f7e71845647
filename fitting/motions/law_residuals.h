// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fitting/motions/fit_parameters.h"
#include "fitting/motions/law_limits.h"
#include "fitting/motions/motion_residuals.h"
#include "optim/fit/remembered_residuals.h"

namespace camlaw::problems {

/// Between which places a motion is looked for.
struct MotionRange {
  double low, high;
};
MotionRange range_of(const MotionGuess& guess);

/// Begin, end, stroke, of displacements the zero shift, and a law's coefficients, as MotionLayout
/// has them.
FitParameters parameters_of(const MotionSamples& samples, const Member& law,
                            const MotionGuess& guess, Skew skew);

/// The residuals of one law as they are fitted: with what its coefficients must meet together.
class LawResiduals {
 public:
  LawResiduals(StandIns samples, const Member& law, Skew skew, FitParameters parameters);
  LawResiduals(const LawResiduals&) = delete;
  LawResiduals& operator=(const LawResiduals&) = delete;

  /// How many parameters stand before the coefficients.
  std::size_t first() const { return motion_.layout().first(); }
  const optim::Residuals& residuals() const { return *remembered_; }
  /// The parameters as they are fitted.
  FitParameters own() const;
  /// Where derivatives of the law at values of own() may jump.
  std::vector<double> breaks(std::span<const double> values) const;
  /// A fit of own() as one of the parameters that were given.
  optim::FitResult told(optim::FitResult fit, double confidence) const;

 private:
  FitParameters given_;
  MotionResiduals motion_;
  std::optional<LimitedResiduals> limited_;
  std::optional<optim::RememberedResiduals> remembered_;
};

/// How such residuals are fitted.
optim::FitOptions fit_options(const LawFitOptions& options, optim::FitReach reach);

}  // namespace camlaw::problems
