// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/verdict/conditions.h"

namespace camlaw::optim {

/// Which of the limits that push, numbers and variables' bounds, have a price that small steps do
/// not bear out: a step by a millionth of the limit's size, or by its tolerance where that is less,
/// to either side. There the limit's slope or what the others leave of the objective's slope
/// differs from that at the design by more than half, or is not a number, or the step is longer
/// than typical changes of the variables (docs/optimisation.md, "Prices"). The indexes into the
/// limits.
std::vector<std::size_t> unborne_prices(const Problem& problem, const Scales& scales, Design x,
                                        const Layout& layout, const Weighed& weighed);

}  // namespace camlaw::optim
