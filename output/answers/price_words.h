// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/optimum_output.h"

namespace camlaw::cli {

/// Multipliers are prices of the objective where every limit is met; else they only weigh the
/// limits that contradict one another.
bool has_prices(const optim::Assessment& assessment);

/// Why what some limits cost is not known; empty where all is.
std::string unknown_price_words(const Answer& answer);

/// What one unit more of each pushing limit buys, in words; `why` some of it is not known.
std::string price_words(const Answer& answer, const std::string& why);

}  // namespace camlaw::cli
