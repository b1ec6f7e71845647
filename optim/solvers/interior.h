// SPDX-License-Identifier: MIT
#pragma once

#include "optim/solvers/solver.h"

namespace camlaw::optim {

/// An interior-point method of camlaw's own, for linear programs of many variables with local rows
/// and few equations.
const Solver& interior_solver();

}  // namespace camlaw::optim
