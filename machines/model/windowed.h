// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"
#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// Where the segment that a window names lies at the law's own values, in the curve's unit. Throws
/// std::invalid_argument with the names of the law's segments where there is none.
std::pair<double, double> window_at(const CycleWindow& window, const Cycle& cycle,
                                    const Member& law);

/// A response's curve over a window alone.
std::shared_ptr<const optim::Curve> windowed(std::shared_ptr<const optim::Curve> curve,
                                             const CycleWindow& window,
                                             const MechanismResponse& response,
                                             const Binding& binding);

}  // namespace camlaw::problems
