// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "machines/model/cycle.h"
#include "machines/model/law_binding.h"
#include "optim/problem/function.h"

namespace camlaw::problems {

/// The piece of a law that ends at x and meets a next one there, but for rounding.
std::optional<std::size_t> joint_at(const Law<double>& law, double x);

/// Where a piece of a law ends in a stretch of the cycle, in the cycle's unit, by the design: what
/// Curve::joint_angle gives.
optim::Function joint_angle_of(std::shared_ptr<const LawBinding> law, std::size_t piece,
                               const Stretch& stretch);

/// An angle that no variable moves.
optim::Function still_angle(double angle);

}  // namespace camlaw::problems
