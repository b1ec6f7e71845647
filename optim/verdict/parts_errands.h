// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "optim/crew/crew.h"
#include "optim/verdict/drawn_parts.h"

/// Parts that are counted by processes side by side, or by other machines (optim/crew/crew.h).
namespace camlaw::optim {

/// Carries draws out as a worker does. The drawer is referred to.
Service parts_service(const PartsDrawer& drawer);

/// Counts by `hands`. `planned`: how many parts the whole work draws, about. All are referred to.
/// Throws std::runtime_error where a draw was lost, as the workers that had it ended.
CountParts counted_by(const Hands& hands, const PartsDrawer& drawer, std::size_t planned,
                      const std::function<bool()>& stopped);

}  // namespace camlaw::optim
