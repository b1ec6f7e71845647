// SPDX-License-Identifier: MIT
#pragma once

#include "optim/fit/fit_point.h"

/// The last digits of a fit.
namespace camlaw::optim {

/// Gauss-Newton steps from a point near a minimum until neither the sum of squares falls nor the
/// part of the residuals that the model can still follow: (FT4) of docs/optimisation.md, which
/// tells parameters apart that the sum no longer does. They end before where that part is at most
/// the share `enough` of the residuals.
FitPoint polish(const Residuals& residuals, const FitBox& box, double enough, FitPoint point);

}  // namespace camlaw::optim
