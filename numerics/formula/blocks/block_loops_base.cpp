// SPDX-License-Identifier: MIT
#include "numerics/formula/blocks/block_loops.h"

namespace camlaw {

extern const BlockKernels kBlockKernels_base;
constinit const BlockKernels kBlockKernels_base = block_loops::kernels<2>("any");

}  // namespace camlaw
