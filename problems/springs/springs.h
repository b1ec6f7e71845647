// SPDX-License-Identifier: MIT
#pragma once

#include "problems/mechanism/mechanism.h"

/// Springs between two deflections, as problem files see them. Formulas: kinematics/springs.
namespace camlaw::problems {

Mechanism disc_springs_mechanism();    ///< "disc-springs"
Mechanism helical_spring_mechanism();  ///< "helical-spring"

}  // namespace camlaw::problems
