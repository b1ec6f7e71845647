// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// "signature-feeder". Curves run over a turn of the crank, 0 to 360 degrees, from where its pin is
/// nearest to the guide's centre.
Mechanism signature_feeder_mechanism();

}  // namespace camlaw::problems
