// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/law.h"
#include "numerics/spline/smoothing_spline.h"

/// Splines through samples, as laws: data like any other law, which files hold to the last bit.
namespace camlaw::problems {

/// The spline over its whole range as a law: x from 0 to 1, displacement (s - zero) / stroke, one
/// polynomial for each span. A periodic one is a law over the cycle, with any motion at its ends.
/// Throws std::invalid_argument for a stroke that is 0 or not finite.
Law<double> spline_law(const optim::SmoothingSpline& spline, double zero, double stroke);

/// The same as the law of one stretch, displacement from 0 to 1; the stroke may be below 0, for a
/// return. Throws std::invalid_argument for a periodic spline and where it ends as high as it
/// begins.
Law<double> stretch_law(const optim::SmoothingSpline& spline);

}  // namespace camlaw::problems
