// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/linear/linear_program.h"
#include "optim/solvers/program.h"

namespace camlaw::optim {

/// A program whose functions are linear, as numbers: a linear function is told by its value and its
/// gradient at one point. Rows keep their order; what they say at zero is taken into their bounds.
LinearProgram read_off(const Program& program, std::span<const double> y);

/// Whether costs, rows and what they say at the point are numbers.
bool is_finite(const LinearProgram& program);

}  // namespace camlaw::optim
