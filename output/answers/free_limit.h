// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "output/answers/optimum_output.h"

namespace camlaw::cli {

/// How far a free law comes in a problem whose law is chosen among named ones.
struct FreeLimit {
  std::optional<double> objective = {};  ///< in its unit; none: see why_none
  std::string verdict = {};              ///< on the design with the free law
  std::string why_none = {};             ///< in words
  std::string law = {};                  ///< in words
};

/// Searches an answer's problem once more with a free law in place of the laws to choose from
/// (with_free_law) of ever more knots, and every other choice and variable open again. None is told
/// that is worse than a law of the table, unless it is certified. `rest` says how, with what is
/// left of the time and what may stop it; in up to so many processes. The search may take as long
/// as the answer's own, and 20 s at least.
FreeLimit free_limit(const Answer& answer, const optim::OptimiseOptions& rest, int workers);

}  // namespace camlaw::cli
