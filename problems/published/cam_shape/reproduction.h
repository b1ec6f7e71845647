// SPDX-License-Identifier: MIT
#pragma once

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// Computes every printed optimum of the cam-shape problem again (cam_shape.csv) and finds the one
/// departure that the value for n = 1000 needs: rows widened by 1e-8, as Ipopt does unless told
/// otherwise.
SystemReproduction reproduce_cam_shape();

}  // namespace camlaw::problems
