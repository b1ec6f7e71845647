// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/inner_numbers.h"

/// Means of a torque over the turn, and the work beyond the mean (docs/theory.md, "Mean torque,
/// surplus work and flywheel").
namespace camlaw::problems {

/// (SH3) The mean of a curve over the turn of a cam, in the curve's unit.
InnerNumber turn_mean(const std::string& name, const MechanismResponse& curve);

/// (SH4) Of a cam's torque T, N m, over its angle psi: the integral of T less its mean, J, counted
/// from its own mean over the turn. It is continuous, periodic, and enclosed at every place.
MechanismResponse surplus_work(const std::string& name, const MechanismResponse& torque);

}  // namespace camlaw::problems
