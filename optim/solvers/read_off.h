// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/linear/quadratic_program.h"
#include "optim/solvers/program.h"

namespace camlaw::optim {

/// The rows' gradients.
Eigen::SparseMatrix<double, Eigen::RowMajor> jacobian_matrix(const Program& program,
                                                             std::span<const double> y);

/// A program whose functions are linear, as numbers: a linear function is told by its value and its
/// gradient at one point. Rows keep their order; what they say at zero is taken into their bounds.
QuadraticProgram read_off(const Program& program, std::span<const double> y);

/// Whether costs, rows and what they say at the point are numbers.
bool is_finite(const QuadraticProgram& program);

}  // namespace camlaw::optim
