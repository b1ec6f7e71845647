// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

/// Cams that a motion program drives, as problem files see them. Their formulas are in the headers
/// of the same names.
namespace camlaw::problems {

Mechanism roller_cam_mechanism();           ///< "disc-cam-roller"
Mechanism flat_cam_mechanism();             ///< "disc-cam-flat"
Mechanism knife_cam_mechanism();            ///< "disc-cam-knife"
Mechanism conjugate_cam_mechanism();        ///< "disc-cam-conjugate"
Mechanism swinging_roller_cam_mechanism();  ///< "disc-cam-swinging-roller"
Mechanism leading_roller_cam_mechanism();   ///< "disc-cam-leading-roller"
Mechanism swinging_flat_cam_mechanism();    ///< "disc-cam-swinging-flat"
Mechanism end_cam_mechanism();              ///< "end-cam"
Mechanism swinging_end_cam_mechanism();     ///< "end-cam-swinging"
Mechanism linear_cam_mechanism();           ///< "linear-cam"

}  // namespace camlaw::problems
