// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/block_loops.h"

namespace camlaw {

extern const BlockKernels kBlockKernels_avx2;
constinit const BlockKernels kBlockKernels_avx2 = block_loops::kernels<4>("AVX2");

}  // namespace camlaw
