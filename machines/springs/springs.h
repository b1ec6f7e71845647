// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

/// Springs between two deflections, as problem files see them. Their formulas
/// are in disc_spring_stack.h and helical_spring.h.
namespace camlaw::problems {

Mechanism disc_springs_mechanism();    ///< "disc-springs"
Mechanism helical_spring_mechanism();  ///< "helical-spring"

}  // namespace camlaw::problems
