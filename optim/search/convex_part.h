// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/search/trail.h"

namespace camlaw::optim {

/// Where to begin a later start of a search whose variables are many, or have bounds far apart.
/// Drawn at random they are of little use: the coefficients of a free law make a law of wild
/// accelerations. So the second start is the optimum of what those limits leave of which the shapes
/// show that they leave a convex set; the others are the designs there that lie farthest towards
/// the `start` that was drawn. That itself where there is no such limit. It counts as work of the
/// trail.
std::vector<double> begun_in_convex_part(Design start, const Setting& setting, Trail& trail);

}  // namespace camlaw::optim
