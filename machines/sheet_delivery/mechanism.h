// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// "sheet-delivery". Curves run along the curved guide, x from 0 (straight) to 1 (its greatest
/// offset).
Mechanism sheet_delivery_mechanism();

}  // namespace camlaw::problems
