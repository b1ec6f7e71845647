// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "optim/problem/curve.h"

/// Places at which a curve over the cycle has no bound.
namespace camlaw::optim {

/// The place beside a peak at which sign * curve has no bound: nothing bounds it there, and it goes
/// on rising (docs/theory.md, "Poles"). None where it has one, as far as is seen.
std::optional<Place> pole_near(const Trace& trace, double sign, const Place& peak);

}  // namespace camlaw::optim
