// SPDX-License-Identifier: MIT
#pragma once

#include "optim/cycle/scales.h"

namespace camlaw::optim {

/// Whether some size or tolerance of a problem is another by more than a factor of ten: then what
/// is scaled by the one is badly scaled for the other.
bool differ(const Scales& a, const Scales& b);

}  // namespace camlaw::optim
