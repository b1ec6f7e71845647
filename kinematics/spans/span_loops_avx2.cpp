// SPDX-License-Identifier: MIT
#include "kinematics/spans/span_loops.h"

namespace camlaw {

extern const SpanKernels kSpanKernels_avx2;
constinit const SpanKernels kSpanKernels_avx2 = span_loops::kernels<4>("AVX2");

}  // namespace camlaw
