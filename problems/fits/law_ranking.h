// SPDX-License-Identifier: MIT
#pragma once

#include "problems/fits/law_fit.h"

namespace camlaw::problems {

/// Each of the laws, by AICc; first of those within two of the best, which explain the samples as
/// well (Burnham and Anderson 2002), the one with the fewest parameters. Laws that cannot be fitted
/// are left out.
std::vector<LawFit> rank_fits(const MotionSamples& samples, const std::vector<Member>& laws,
                              const MotionGuess& guess, const LawFitOptions& options = {});

}  // namespace camlaw::problems
