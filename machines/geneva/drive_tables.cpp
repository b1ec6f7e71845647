// SPDX-License-Identifier: MIT
#include "machines/geneva/drive_tables.h"

namespace camlaw::problems {

std::vector<MechanismParameter> drive_parameters() {
  return {{"slots", "n", "1", "1", "slots of the wheel", 6, 3, 60, true},
          {"speed", "n_d", "rpm", "rad/s", "speed of the driver", 60, 1e-3, 1e6},
          {"inertia", "J", "kg m2", "kg m2",
           "moment of inertia of everything that moves, referred to the wheel", 0.8, 0, 1e6},
          {"friction", "M_f", "N m", "N m", "friction torque at the wheel while it moves", 40, 1e-6,
           1e9}};
}

}  // namespace camlaw::problems
