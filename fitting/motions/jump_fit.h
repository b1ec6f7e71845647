// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "fitting/samples/motion_samples.h"
#include "optim/fit/least_squares.h"
#include "optim/fit/residuals.h"

namespace camlaw::problems {

/// Which ends of a motion its samples jump at: those of a derivative that is not zero there.
struct EndJumps {
  bool begin = false, end = false;
  bool any() const { return begin || end; }
};

/// A fit to samples that jump where the motion begins or ends. The sum of squares is then a step
/// function of that end, which descent does not follow: between two neighbouring places the end may
/// lie anywhere as far as the jump goes. So gaps between places are tried, and what the jump tells
/// of an end (LC5) joins what the other samples tell. `fit` are parameters whose first two are
/// begin and end, as they were fitted to `residuals` without that: to those of the samples, or of
/// their stand-ins that are for a law which jumps there.
optim::FitResult fit_with_jumps(const MotionSamples& samples, const optim::Residuals& residuals,
                                const std::vector<optim::FitParameter>& parameters, EndJumps jumps,
                                const optim::FitOptions& options, optim::FitResult fit);

}  // namespace camlaw::problems
