// SPDX-License-Identifier: MIT
#pragma once

#include "optim/solvers/solver.h"

namespace camlaw::optim {

/// Smooth problems of many variables whose rows are local: a convex quadratic program after another
/// in a trust region, each by camlaw's interior-point method (docs/optimisation.md, "Sequential
/// programming").
const Solver& sequential_solver();

}  // namespace camlaw::optim
