// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// Whether a check is about what a machine has only where it is stated, by parameters that are 0
/// otherwise: friction in a guide.
bool is_of_added_part(const Mechanism& mechanism, const BuildableCheck& check);

/// Whether the machine of these stated numbers has what a check is about.
bool has_part_of(const Mechanism& mechanism, const BuildableCheck& check,
                 const StatedNumber& stated);

}  // namespace camlaw::problems
