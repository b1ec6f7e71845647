// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "problems/published/table/reproduction.h"

namespace camlaw::problems {

/// Computes every printed optimum of the cam-shape problem again (cam_shape.csv) and finds the one
/// departure that the value for n = 1000 needs: rows widened by 1e-8, as Ipopt does unless told
/// otherwise. Throws optim::Interrupted where `stop` is set before the end.
SystemReproduction reproduce_cam_shape(const std::atomic<bool>* stop = nullptr);

}  // namespace camlaw::problems
