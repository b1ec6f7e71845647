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

/// Of an infeasible answer, by how much what limits would have to be eased, in the words of
/// price_words: each alone, or where none alone helps all those together that the design shown does
/// not meet. Empty for other answers, and where the search ended at no design.
std::string cure_words(const Answer& answer);
/// The same for programs: name, side, whether it is a variable's bound, unit, bound and `by`.
Json cures_json(const Answer& answer);

}  // namespace camlaw::cli
