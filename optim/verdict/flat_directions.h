// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/verdict/second_order.h"

namespace camlaw::optim {

/// Whether a few steps along directions in which the Lagrangian does not curve (SecondOrder::flat)
/// lead to a better design that meets every limit: better by more than the conditions' own
/// tolerance and what violations within their tolerance are worth. Looks at the first directions
/// only.
bool improves_along(const SecondOrderPoint& point, const Weighed& weighed,
                    const std::vector<Eigen::VectorXd>& flat);

}  // namespace camlaw::optim
