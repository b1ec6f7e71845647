// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/verdict/verdict.h"

namespace camlaw::optim {

/// How the combinations went, for the words of the verdict.
struct CombinationTally {
  std::size_t combinations = 0, solved = 0, missed = 0;
  bool all_infeasible = true, complete = true, bounds_hold = true, enumerated = true;
  bool neighbours_tried = true;             ///< of what was not enumerated (IntegerOutcome)
  std::string stopped = {};                 ///< why the search ended early, where it did
  std::vector<std::string> unsettled = {};  ///< combinations of choices, in words
};

/// What a search over combinations adds to the verdict of the best one.
void judge_combinations(const CombinationTally& tally, Assessment& a);

}  // namespace camlaw::optim
