// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "optim/search/trail.h"

namespace camlaw::optim {

/// A design within the limits that is better than what a search has found, by more than the
/// objective's tolerance: the best of 500 that fill the box. Looked for where objective and limits
/// are numbers that are no searches themselves, of up to ten variables; empty elsewhere. A method
/// may step over the ridge, or the pole, that its start lies behind.
std::optional<std::vector<double>> better_elsewhere(const Setting& setting, const Trail& trail);

}  // namespace camlaw::optim
