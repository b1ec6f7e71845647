// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "optim/problem/problem.h"
#include "optim/verdict/assessment.h"

/// A multiplier that is not a price is NaN (docs/optimisation.md, "Prices").
namespace camlaw::optim {

/// The residual of the conditions of optimality up to which multipliers are prices, which are told
/// in four digits.
inline constexpr double kPriceTolerance = 1e-5;

/// Where the conditions of optimality do not hold to kPriceTolerance no multiplier stays a number;
/// limits that the design keeps clear of cost nothing.
void drop_unknown_prices(Assessment& assessment);

/// Says why multipliers of an assessment at a design are not numbers; empty where all are.
std::string why_no_price(const Problem& problem, const Assessment& assessment, Design x);

}  // namespace camlaw::optim
