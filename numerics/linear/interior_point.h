// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/linear/bounded_problem.h"
#include "numerics/linear/column_factors.h"

namespace camlaw::optim {

struct InteriorPoint {
  Eigen::VectorXd m;      ///< positive where bounded
  Eigen::VectorXd slope;  ///< of half |A m + b|^2, by m; positive where bounded, zero where free
  int factorizations = 0;
};

/// The bounded problem's answer, nearly, by a primal-dual method with predictor and corrector
/// (Mehrotra 1992). Takes some 25 factorizations, whatever the number of bounds; of many answers it
/// finds one amid them. Starts at the size of `guess`.
InteriorPoint interior_point(const BoundedProblem& problem, const Eigen::VectorXd& guess,
                             Factorize factorize);

}  // namespace camlaw::optim
