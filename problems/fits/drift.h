// SPDX-License-Identifier: MIT
#pragma once

#include "problems/fits/law_fit.h"

namespace camlaw::problems {

/// A slope that samples of a displacement have beside the law's motion.
struct Drift {
  double over_record = 0;  ///< what it makes from the first place to the last
  double deviations = 0;   ///< of its own standard deviation
};

/// What a slope would follow of the residuals that the law, with its numbers fitted anew, does not:
/// to first order, by least squares. None of samples of derivatives, and too few ones.
Drift drift_of(const MotionSamples& samples, const LawFit& fit);

}  // namespace camlaw::problems
