// SPDX-License-Identifier: MIT
#pragma once

#include "optim/cycle/sizes.h"

namespace camlaw::optim {

/// Whether some size or tolerance of a problem is another by more than a factor of ten: then what
/// is scaled by the one is badly scaled for the other.
bool differ(const Sizes& a, const Sizes& b);

}  // namespace camlaw::optim
