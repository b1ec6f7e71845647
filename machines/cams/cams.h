// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

/// Cams that a motion program drives, as problem files see them. Their formulas are in the headers
/// of the same names.
namespace camlaw::problems {

Mechanism roller_cam_mechanism();              ///< "disc-cam-roller"
Mechanism flat_cam_mechanism();                ///< "disc-cam-flat"
Mechanism knife_edge_cam_mechanism();          ///< "disc-cam-knife-edge"
Mechanism conjugate_cam_mechanism();           ///< "disc-cam-conjugate"
Mechanism oscillating_roller_cam_mechanism();  ///< "disc-cam-oscillating-roller"
Mechanism leading_roller_cam_mechanism();      ///< "disc-cam-leading-roller"
Mechanism oscillating_flat_cam_mechanism();    ///< "disc-cam-oscillating-flat"
Mechanism end_cam_mechanism();                 ///< "end-cam"
Mechanism oscillating_end_cam_mechanism();     ///< "end-cam-oscillating"
Mechanism linear_cam_mechanism();              ///< "linear-cam"

}  // namespace camlaw::problems
