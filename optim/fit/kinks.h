// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "optim/fit/fit_point.h"

/// Minima of fits at kinks of their residuals.
namespace camlaw::optim {

/// The minimum at kinks near a point at which steps along the slopes end though the model can still
/// follow. A residual with a kink is continuous, and its derivatives jump, as those of an
/// acceleration's sample where a motion begins. The sum of squares may be least at such a place:
/// then some value between the two sides of each row with a kink makes it stationary, (FT9) of
/// docs/optimisation.md. The Jacobian of the result has these values. Nothing where no such minimum
/// is found, as where a residual jumps.
std::optional<FitPoint> minimum_at_kinks(const Residuals& residuals, const FitBox& box,
                                         FitPoint point);

}  // namespace camlaw::optim
