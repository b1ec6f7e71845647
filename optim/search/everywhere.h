// SPDX-License-Identifier: MIT
#pragma once

#include "optim/search/local.h"

namespace camlaw::optim {

/// A search in the continuous variables, and a look at what it may have missed while there is time.
/// `known` as search_continuous() takes it.
Found search_everywhere(const Problem& problem, const OptimiseOptions& how,
                        const Deadline& deadline, std::vector<FromStart> known);

}  // namespace camlaw::optim
