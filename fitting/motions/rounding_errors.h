// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/samples/motion_samples.h"
#include "optim/fit/least_squares.h"
#include "optim/fit/residuals.h"

namespace camlaw::problems {

/// Below this a sum of squares is that of rounding, of doubles or of the values as written: it
/// tells no laws apart.
double least_sum_of_squares(const MotionSamples& samples);

/// Covariance and intervals of a fit to rounded values (LC4): where noise is less than the step,
/// neighbours on a slow stretch are rounded alike, and their mean is not nearer than one of them.
/// `given` are the parameters as they were fitted, `residuals` what they were fitted to: those of
/// all samples or of their stand-ins; `all` are those of all. Without rounding nothing changes.
/// Returns by how much each deviation has grown; 1 where it has none.
std::vector<double> count_rounding(const MotionSamples& samples, const optim::Residuals& residuals,
                                   const optim::Residuals& all,
                                   const std::vector<optim::FitParameter>& given, double confidence,
                                   optim::FitResult& fit);

}  // namespace camlaw::problems
