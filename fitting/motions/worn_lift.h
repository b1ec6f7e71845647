// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/fitted_cycle.h"

/// Worn stretches in a measured lift.
namespace camlaw::problems {

/// Trusts no motion of a lift that a law without coefficients and a stretch that departs from it
/// explain as well as, or better than, the law that was found ((WR1) in docs/optimisation.md): of
/// the motions that are trusted with a law of coefficients, which may have followed the stretch,
/// and of those whose residuals are a curve, where the stretch is lower than the law. `first`: the
/// record's first place. Nothing is done under a loss, of derivatives, and after the deadline.
void weigh_worn_stretches(const std::vector<Member>& laws, const LawFitOptions& options,
                          double first, FittedCycle& cycle);

}  // namespace camlaw::problems
