// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// Adds what turns a shaft, and what makes it turn evenly, where each of its cams has a drive
/// torque over its turn (docs/theory.md, "Mean torque, surplus work and flywheel"): the torque and
/// its mean, root mean square, ripple and power; the surplus work, its fluctuation and the flywheel
/// that it needs; the lift of a balancing cam, its stroke and the force of its spring. The
/// coefficient of speed fluctuation and the balancing spring become parameters of the shaft.
void add_shaft_torque(Mechanism& shaft);

}  // namespace camlaw::problems
