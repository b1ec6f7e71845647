// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// Whether the model has no numbers anywhere within the bounds of the variables, in words: the box
/// is halved until in each part one function of Problem::domain is enclosed below 0. None where
/// that is not shown: the problem has no domain, a bound is infinite, a design was met at which all
/// of the functions are above 0, or the parts are too many.
std::optional<std::string> none_possible(const Problem& problem);

}  // namespace camlaw::optim
