// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/linear/bounded_problem.h"
#include "numerics/linear/column_factors.h"
#include "numerics/linear/least_squares.h"

namespace camlaw::optim {

/// The active-set search of bounded_least_squares, for finite A with columns of lengths near one;
/// leaves residual_max to the caller.
LeastSquaresResult bounded_search(const BoundedProblem& problem, Factorize factorize);

}  // namespace camlaw::optim
