// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/multi_problem.h"

namespace camlaw::optim {

/// The costs of a design.
std::vector<double> costs(const MultiProblem& problem, Design x);

}  // namespace camlaw::optim
