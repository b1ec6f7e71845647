// SPDX-License-Identifier: MIT
#pragma once

#include <set>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// The variables that a response depends on: of a curve at the beginning of each smooth stretch of
/// the problem's start, or at some places within.
std::set<std::size_t> inputs_of(const Response& response, const Problem& problem);

}  // namespace camlaw::optim
