// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "numerics/linear/quadratic_program.h"
#include "optim/solvers/program.h"
#include "optim/solvers/solver.h"

namespace camlaw::optim {

/// The rows' gradients.
Eigen::SparseMatrix<double, Eigen::RowMajor> jacobian_matrix(const Program& program,
                                                             std::span<const double> y);

/// A program whose functions are linear, as numbers: a linear function is told by its value and its
/// gradient at one point. Rows keep their order; what they say at zero is taken into their bounds.
QuadraticProgram read_off(const Program& program, std::span<const double> y);

/// The same where a search of a linear program starts, with what this tells of the solution so far:
/// one evaluation. None, and Status::NonFiniteStart, where costs, rows or what they say at the
/// start are not numbers.
std::optional<QuadraticProgram> read_at_start(const Program& program, std::span<const double> start,
                                              Solution& solution);

}  // namespace camlaw::optim
