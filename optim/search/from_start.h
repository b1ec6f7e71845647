// SPDX-License-Identifier: MIT
#pragma once

#include "optim/search/trail.h"

namespace camlaw::optim {

/// Searches from one start, through the methods of the plan until the conditions of optimality
/// hold. Returns the best design that it came to, which joins the trail where it is better than
/// what was there.
Assessment search_from_start(Design start, const Setting& setting, Trail& trail);

}  // namespace camlaw::optim
