// SPDX-License-Identifier: MIT
#include "kinematics/spans/span_loops.h"

namespace camlaw {

extern const SpanKernels kSpanKernels_avx512;
constinit const SpanKernels kSpanKernels_avx512 = span_loops::kernels<8>("AVX-512");

}  // namespace camlaw
