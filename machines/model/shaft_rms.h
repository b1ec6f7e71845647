// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// (SH5) The root of the mean square of a sum of cams' curves over the turn of their shaft, each
/// cam at its phase; of the response, which has its names and unit, the rest is filled in. NaN
/// where the velocity of a motion jumps: a mean cannot represent that pulse.
MechanismResponse shaft_rms(MechanismResponse response, const std::vector<HeldCurve>& curves);

}  // namespace camlaw::problems
