// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// The two balancing coefficients that the paper prints (balancing_cam.csv). It prints no loads, so
/// they cannot be computed: each names the ratio of inertia to friction, J omega^2 / M_f, that an
/// ideal balance would need, for several numbers of slots.
SystemReproduction reproduce_balancing_cam();

}  // namespace camlaw::problems
