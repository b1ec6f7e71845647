// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// "balancing-cam", of a planar Geneva, and "balancing-cam-spherical". Curves run over the driver's
/// turn from the beginning of the engagement.
Mechanism planar_balancing_cam_mechanism();
Mechanism spherical_balancing_cam_mechanism();

}  // namespace camlaw::problems
