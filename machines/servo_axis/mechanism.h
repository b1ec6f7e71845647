// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// "servo-axis", which turns its load, and "linear-servo-axis". Curves run over the cycle, 0 to 360
/// degrees.
Mechanism servo_axis_mechanism();
Mechanism linear_servo_axis_mechanism();

}  // namespace camlaw::problems
