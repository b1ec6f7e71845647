// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/block_kernels.h"

#include <vector>

namespace camlaw {

extern const BlockKernels kBlockKernels_base;
#ifdef CAMLAW_X86
extern const BlockKernels kBlockKernels_avx2, kBlockKernels_avx512;
#endif

std::span<const BlockKernels* const> block_kernels() {
  static const std::vector<const BlockKernels*> all = [] {
    std::vector<const BlockKernels*> known;
#ifdef CAMLAW_X86
    if (__builtin_cpu_supports("avx512f")) known.push_back(&kBlockKernels_avx512);
    if (__builtin_cpu_supports("avx2")) known.push_back(&kBlockKernels_avx2);
#endif
    known.push_back(&kBlockKernels_base);
    return known;
  }();
  return all;
}

}  // namespace camlaw
