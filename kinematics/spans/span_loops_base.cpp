// SPDX-License-Identifier: MIT
#include "kinematics/spans/span_loops.h"

namespace camlaw {

extern const SpanKernels kSpanKernels_base;
constinit const SpanKernels kSpanKernels_base = span_loops::kernels<2>("any");

}  // namespace camlaw
