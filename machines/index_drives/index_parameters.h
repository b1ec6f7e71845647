// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_parameters.h"

/// Parameters that index drives have alike.
namespace camlaw::turrets {

inline constexpr MachineParameter kStations{
    "stations", "S", "1", "1", "stops of the turret per revolution", 4, 3, 60, true},
    kRollers{"rollers", "N", "1", "1", "rollers of the turret", 8, 3, 60, true},
    kAxisDistance{
        "axis_distance", "a", "mm", "m", "centre distance of cam and turret", 80, 1e-3, 1e5},
    kTurretRadius{"turret_radius",
                  "R_t",
                  "mm",
                  "m",
                  "radius of the circle on which the rollers' centres lie",
                  80,
                  1e-3,
                  1e5},
    kRollerRadius{"roller_radius", "r_r", "mm", "m", "radius of a roller", 12, 1e-3, 1e5},
    kSpeed = cams::kSpeed.by_default(100),
    kInertia{"inertia",
             "J",
             "kg m2",
             "kg m2",
             "moment of inertia of everything that turns with the turret",
             0.1,
             0,
             1e6},
    kFriction{"friction_torque",
              "M_C",
              "N m",
              "N m",
              "friction torque on the turret, which opposes its motion at any speed",
              0,
              0,
              1e9},
    kLoad{"load_torque",
          "M_L",
          "N m",
          "N m",
          "constant torque on the turret that opposes its motion",
          0,
          -1e9,
          1e9},
    kRollerLength = cams::kFaceWidth.meaning_that("length of the contact along a roller"),
    kTrainStiffness = cams::kArmTrainStiffness.meaning_that(
        "stiffness of the train between turret and table; 0 makes the train rigid, and the "
        "responses "
        "of its end are undefined"),
    kCrownRadius = cams::kCrownRadius.with_symbol("R_k");  // R_c is a barrel's radius

}  // namespace camlaw::turrets
