// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "machines/model/box_traces.h"
#include "machines/model/shaft_curve.h"

namespace camlaw::problems {

/// Bounds over boxes of a curve that is made of the machine's own curves: of those over the box,
/// and of the formula over what they bound. Null where a curve stands at a phase, or where one of
/// them is not bounded.
std::unique_ptr<OverBoxes> held_over_boxes(std::shared_ptr<const ShaftParts> parts,
                                           const Widened& wide, optim::Design x);

}  // namespace camlaw::problems
