// SPDX-License-Identifier: MIT
#include "kinematics/spans/span_kernels.h"

#include <vector>

namespace camlaw {

extern const SpanKernels kSpanKernels_base;
#ifdef CAMLAW_X86
extern const SpanKernels kSpanKernels_avx2, kSpanKernels_avx512;
#endif

std::span<const SpanKernels* const> span_kernels() {
  static const std::vector<const SpanKernels*> all = [] {
    std::vector<const SpanKernels*> known;
#ifdef CAMLAW_X86
    if (__builtin_cpu_supports("avx512f")) known.push_back(&kSpanKernels_avx512);
    if (__builtin_cpu_supports("avx2")) known.push_back(&kSpanKernels_avx2);
#endif
    known.push_back(&kSpanKernels_base);
    return known;
  }();
  return all;
}

}  // namespace camlaw
