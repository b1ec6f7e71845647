// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// "die-press". Curves run over the cam angle, 0 to 360 degrees: the stroke and its return.
Mechanism die_press_mechanism();

}  // namespace camlaw::problems
