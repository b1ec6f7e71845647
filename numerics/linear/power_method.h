// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

namespace camlaw::optim {

/// Largest eigenvalue of a positive semidefinite matrix, from a random start: the largest on the
/// span of the power method's directions (Lanczos), of which a few dozen do. `times` gives the
/// matrix times a vector. Never above it by more than rounding, and below it by 1e-6 of it at most,
/// unless many eigenvalues lie close to the largest. 0 for size 0.
double largest_eigenvalue(Eigen::Index size,
                          const std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>& times);

/// Largest over least singular value; infinity where rounding does not tell the least from 0, or
/// one of them is not a number.
double condition_of(double largest, double least);

}  // namespace camlaw::optim
