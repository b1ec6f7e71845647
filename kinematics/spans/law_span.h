// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/law.h"
#include "kinematics/spans/span_kernels.h"

namespace camlaw {

/// evaluate() by the loops of one instruction set; the results are the same to the last bit.
void evaluate_by(const SpanKernels& kernels, const Law<double>& law, std::span<const double> x,
                 MotionSpans out);

}  // namespace camlaw
