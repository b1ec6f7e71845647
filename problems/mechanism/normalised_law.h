// SPDX-License-Identifier: MIT
#pragma once

#include "problems/mechanism/mechanism.h"

namespace camlaw::problems {

/// The motion law alone, "law": its curves over x from 0 to 1, with the constants B, C, D and Cm as
/// named peaks. Peaks are those of the pieces: where acceleration jumps, a pulse of jerk is not
/// counted.
Mechanism normalised_law_mechanism();

}  // namespace camlaw::problems
