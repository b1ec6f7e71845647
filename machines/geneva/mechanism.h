// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// "geneva", planar, and "geneva-spherical". Curves run over the driver's turn from the beginning
/// of the engagement. Formulas: machines/geneva/geneva_drive.h.
Mechanism planar_geneva_mechanism();
Mechanism spherical_geneva_mechanism();

}  // namespace camlaw::problems
