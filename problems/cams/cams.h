// SPDX-License-Identifier: MIT
#pragma once

#include "problems/mechanism/mechanism.h"

/// Cams that a motion program drives, as problem files see them. Formulas: kinematics/cams.
namespace camlaw::problems {

Mechanism roller_cam_mechanism();           ///< "disc-cam-roller"
Mechanism flat_cam_mechanism();             ///< "disc-cam-flat"
Mechanism swinging_roller_cam_mechanism();  ///< "disc-cam-swinging-roller"
Mechanism end_cam_mechanism();              ///< "end-cam"

}  // namespace camlaw::problems
