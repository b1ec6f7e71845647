// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "optim/search/trail.h"

namespace camlaw::optim {

/// Whether objective and limits are numbers that are no searches over the cycle themselves.
bool is_quick(const Problem& problem);

/// A design within the limits that is better than what a search has found, by more than the
/// objective's tolerance: the best of 500 that fill the box where objective and limits are numbers
/// that are no searches themselves, of up to ten variables; of 384 where some are searches over the
/// cycle, of up to four variables; empty elsewhere. A method may step over the ridge, or the pole,
/// that its start lies behind, and all starts may end in the valleys that their box is widest in.
std::optional<std::vector<double>> better_elsewhere(const Setting& setting, const Trail& trail);

}  // namespace camlaw::optim
