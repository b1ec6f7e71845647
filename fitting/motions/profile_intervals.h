// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/fit/least_squares.h"
#include "optim/fit/residuals.h"

namespace camlaw::problems {

/// Intervals of the first `count` parameters of a least-squares fit by its profile (LC4): as far as
/// the sum of squares, the other parameters fitted, stays below
///   S (1 + f^2 t^2 / nu)
/// with Student's t and nu degrees of freedom. Where residuals are linear in the parameters these
/// are the intervals by the deviations; they hold too where they are not, where an end is told by a
/// kink or a jump, and at bounds. `parameters` are as they were fitted, with the fit's values as
/// starts; `inflation` has the f of each parameter: by how much its deviation is larger than that
/// of independent residuals. Parameters that are held or not determined keep their intervals.
/// Throws optim::Interrupted where `stop`, which may be null, is set before the end.
void profile_intervals(const optim::Residuals& residuals,
                       const std::vector<optim::FitParameter>& parameters, std::size_t count,
                       const std::vector<double>& inflation, double confidence,
                       const std::atomic<bool>* stop, optim::FitResult& fit);

}  // namespace camlaw::problems
