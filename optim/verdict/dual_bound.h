// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "optim/verdict/conditions.h"

namespace camlaw::optim {

/// How far variables without a bound are looked at, in their own magnitudes: a slope that rounding
/// leaves has no bound over an infinite line.
inline constexpr double kFar = 1e3;

/// By how much, over the objective's size, a design within the box and the limits may be better
/// than x at most: weak duality with the multipliers of `weighed`, whatever the conditions of
/// optimality say (docs/optimisation.md, "Lower bounds"). Each limit enters by a linear inequality
/// that all designs obey, from its convexity. Empty where the shapes give no such inequalities, and
/// where a function has no value.
std::optional<double> largest_gain(const Problem& problem, const Scales& scales, Design x,
                                   const Layout& layout, const Weighed& weighed);

}  // namespace camlaw::optim
