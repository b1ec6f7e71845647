// SPDX-License-Identifier: MIT
#pragma once

#include "optim/search/trail.h"

namespace camlaw::optim {

/// Whether a design was found at which the model gives numbers.
bool has_numbers(const Found& found);

/// Where a search ended at a design without numbers: searches from designs between its start and
/// that one. Where the model gives no number at any start: from a design that meets those limits
/// that are numbers there, such as those of validity; where there is no such limit, from places of
/// the box at which the model gives numbers. Where no design meets those limits, the problem has
/// none either, for the same reason.
void seek_numbers(const Setting& setting, Trail& trail);

}  // namespace camlaw::optim
