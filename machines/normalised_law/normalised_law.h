// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// The motion law alone, "law": its curves over x from 0 to 1, with the constants B, C, D and Cm as
/// named peaks. A jump of a derivative inside makes the next one infinite; one at the ends counts
/// for the velocity alone, against what the law declares there.
Mechanism normalised_law_mechanism();

}  // namespace camlaw::problems
