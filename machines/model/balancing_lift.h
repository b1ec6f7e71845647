// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// (SH8) The lift of a spring-loaded follower whose cam makes the torque of the shaft constant,
/// over the shaft's angle: the spring of rate k, N/mm, and preload F_0, N, stores what the surplus
/// work W, J, is below its highest. It is 0 where W is highest. `rate` and `preload` are the
/// parameters; of the response, which has its names and the unit mm, the rest is filled in.
MechanismResponse balancing_lift(MechanismResponse response, const MechanismResponse& work,
                                 std::size_t rate, std::size_t preload);

}  // namespace camlaw::problems
