// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/function.h"

/// Sums of functions of a design.
namespace camlaw::optim {

/// sum of weights[i] * parts[i], the weights above 0.
Function weighted_sum(const std::vector<Function>& parts, const std::vector<double>& weights);

}  // namespace camlaw::optim
