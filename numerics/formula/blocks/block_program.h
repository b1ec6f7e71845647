// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/formula/blocks/block_kernels.h"
#include "numerics/formula/formula.h"

namespace camlaw {

/// The moving steps of several formulas over one list of steps, as BlockKernels runs them. Rows are
/// numbered through: the values of the formulas, registers, inputs that move, and the results of
/// single steps that stay.
struct BlockProgram {
  std::vector<BlockStep> steps;
  std::size_t values = 0, registers = 0, inputs = 0;
  std::vector<std::uint32_t> still;  ///< which steps these are

  std::size_t written() const { return values + registers; }
};

/// `values` are the steps whose results are wanted; inputs from `first` on move, `inputs` of them.
/// A register is used again once no later step needs it.
BlockProgram block_program(const std::vector<Step>& steps, const std::vector<std::uint32_t>& values,
                           std::size_t first, std::size_t inputs);

}  // namespace camlaw
