// SPDX-License-Identifier: MIT
#pragma once

#include "optim/search/trail.h"

namespace camlaw::optim {

/// Where no design within the limits was found: searches for the one of least violation, and from
/// there on for the optimum; or, if that design still violates a limit, reports its verdict.
void find_feasible(const Setting& setting, Trail& trail, Reached& reached);

}  // namespace camlaw::optim
