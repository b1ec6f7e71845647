// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/block_loops.h"

namespace camlaw {

extern const BlockKernels kBlockKernels_avx512;
constinit const BlockKernels kBlockKernels_avx512 = block_loops::kernels<8>("AVX-512");

}  // namespace camlaw
