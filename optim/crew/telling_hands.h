// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "optim/crew/crew.h"

namespace camlaw::optim {

/// Hands that tell after each answer which share of the work has been handed out
/// (Errands::share), 0 to 1.
Hands telling_hands(Hands others, std::function<void(double share)> tell);

}  // namespace camlaw::optim
