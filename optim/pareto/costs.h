// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"

/// Each objective of a front is counted as a cost, which is to be small: an objective to be
/// maximised is counted as its negative.
namespace camlaw::optim {

/// A value of an objective as a cost, or a cost as a value.
double as_cost(const Objective& objective, double value);

/// The costs of a design.
std::vector<double> costs(const Problem& problem, Design x);

/// The limit that an objective's cost is at most `cost`; of a peak at every angle.
Constraint at_most(const Objective& objective, double cost);

}  // namespace camlaw::optim
