// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "optim/cycle/scales.h"
#include "optim/verdict/assessment.h"

namespace camlaw::optim {

/// Which limit of a design that meets every limit, or whether its objective, is not proved, in
/// words; empty where nothing is missing.
std::string unproved(const Problem& problem, const Scales& scales, const Assessment& a);

}  // namespace camlaw::optim
