// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/law.h"
#include "numerics/spline/smoothing_spline.h"

/// Splines through samples, as laws: data like any other law, which files hold to the last bit.
namespace camlaw::problems {

/// The spline over its whole range as a law: x from 0 to 1, displacement (s - zero) / stroke, one
/// polynomial for each span. A periodic one is a law over the cycle, with any motion at its ends.
/// Impossible for a stroke that is 0 or not finite.
Possible<Law<double>> possible_spline_law(const optim::SmoothingSpline& spline, double zero,
                                          double stroke);

/// The same as the law of one stretch, displacement from 0 to 1; the stroke may be below 0, for a
/// return. Impossible for a periodic spline and where it ends as high as it begins.
Possible<Law<double>> possible_stretch_law(const optim::SmoothingSpline& spline);

/// These throw std::invalid_argument where that is impossible.
Law<double> spline_law(const optim::SmoothingSpline& spline, double zero, double stroke);
Law<double> stretch_law(const optim::SmoothingSpline& spline);

}  // namespace camlaw::problems
