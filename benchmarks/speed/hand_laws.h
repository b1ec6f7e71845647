// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "kinematics/law.h"

/// What our hot loop is measured against: for one law each, the loop that an engineer would write
/// by hand for this law alone. The same compiler flags, factored formulas, one sine and cosine a
/// point.
namespace camlaw::benchmarks {

using HandLoop = void (*)(std::span<const double> x, MotionSpans out);

void hand_poly_3_4_5(std::span<const double> x, MotionSpans out);
void hand_poly_4_5_6_7(std::span<const double> x, MotionSpans out);
void hand_cycloidal(std::span<const double> x, MotionSpans out);
void hand_modified_sine(std::span<const double> x, MotionSpans out);

}  // namespace camlaw::benchmarks
