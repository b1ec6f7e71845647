// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

namespace camlaw::optim {

/// Largest eigenvalue of the positive semidefinite matrix whose product with a vector `times` gives,
/// by the power method from a random start: from inside the interval that the eigenvalues span, and
/// to six digits unless many of them lie close to the largest.
double largest_eigenvalue(
    Eigen::Index size, const std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>& times);

}  // namespace camlaw::optim
