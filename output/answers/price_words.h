// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/optimum_output.h"

namespace camlaw::cli {

/// Multipliers are prices of the objective where every limit is met; else they only weigh the
/// limits that contradict one another.
bool has_prices(const optim::Assessment& assessment);

/// The price of a limit as a cell of a table.
std::string price_text(const optim::LimitReport& limit, bool priced);

/// Why what some limits cost is not known; empty where all is.
std::string unknown_price_words(const Answer& answer);

/// What a round step of each pushing limit buys (priced_step), in words; `why` some of it is not
/// known.
std::string price_words(const Answer& answer, const std::string& why);

}  // namespace camlaw::cli
