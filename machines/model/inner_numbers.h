// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "machines/model/mechanism.h"

/// Numbers that a formula holds as a whole.
namespace camlaw::problems {

/// A part of a curve over the cycle, in the curve's listed unit.
InnerNumber inner_peak(const MechanismResponse& curve, optim::Part part);

/// A number of the machine that is not a formula.
InnerNumber inner_number(const MechanismResponse& response);

/// Variables of the design as far as a binding knows them: its first ones.
std::size_t design_size(const Binding& binding);

}  // namespace camlaw::problems
