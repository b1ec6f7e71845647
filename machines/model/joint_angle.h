// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "machines/model/cycle.h"
#include "machines/model/law_binding.h"
#include "optim/problem/function.h"

namespace camlaw::problems {

/// Where a piece of a law ends in a stretch of the cycle, in the cycle's unit, by the design: what
/// Curve::joint_angle gives.
optim::Function joint_angle_of(std::shared_ptr<const LawBinding> law, std::size_t piece,
                               const Stretch& stretch);

/// An angle that no variable moves.
optim::Function still_angle(double angle);

}  // namespace camlaw::problems
