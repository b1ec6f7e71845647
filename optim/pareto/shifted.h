// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// The response plus slope times the design variable `variable`, which comes after all that the
/// response depends on.
Response shifted(const Response& response, double slope, std::size_t variable);

}  // namespace camlaw::optim
