// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"

namespace camlaw::problems {

/// Whether two laws are one motion under two names, such as a quintic and its Legendre series:
/// their displacements differ by less than 1e-9 of the stroke at 64 places.
bool same_motion(const Member& a, const Member& b);

}  // namespace camlaw::problems
