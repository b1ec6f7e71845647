// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "problems/statement/bind.h"

namespace camlaw::problems {

/// Told before each response is evaluated: how many are done, and of how many.
using EvaluationProgress = std::function<void(std::size_t done, std::size_t all)>;

/// As evaluate(statement), and tells how far it is.
std::vector<EvaluatedResponse> evaluate(const ProblemStatement& statement,
                                        const EvaluationProgress& progress);

}  // namespace camlaw::problems
