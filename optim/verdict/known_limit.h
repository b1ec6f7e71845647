// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "optim/problem/problem.h"
#include "optim/verdict/assessment.h"

namespace camlaw::optim {

/// "to within 0.008 %: no design below 2.25, as no law from rest to rest has less", of a design
/// that is_near_limit().
std::string near_limit_words(const Problem& problem, const Assessment& assessment);

}  // namespace camlaw::optim
