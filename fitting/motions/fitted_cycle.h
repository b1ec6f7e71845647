// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/motion_fit.h"

/// The laws behind all motions of a cycle.
namespace camlaw::problems {

struct FittedCycle {
  FoundCycle found;
  std::vector<MotionFit> fits;  ///< of each motion, in order; not empty
  /// Those that were found, with the ends of motions where the fitted laws have them and the
  /// standard errors of these; ends of motions whose law is not trusted stay.
  std::vector<FoundSegment> segments;
};

/// Impossible as possible_motion_fit is.
Possible<FittedCycle> possible_cycle_fit(FoundCycle cycle, const std::vector<Member>& laws,
                                         const LawFitOptions& options = {});
/// The same; throws std::invalid_argument where it is impossible.
FittedCycle fit_cycle(FoundCycle cycle, const std::vector<Member>& laws,
                      const LawFitOptions& options = {});

}  // namespace camlaw::problems
