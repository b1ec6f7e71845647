// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/model/mechanism.h"

/// Named peaks that several cams have alike.
namespace camlaw::problems {

NamedPeak peak_pressure_angle();
NamedPeak peak_undercut();
NamedPeak peak_torque();
NamedPeak peak_stress();
NamedPeak peak_outer_undercut();
NamedPeak peak_groove_stress();
NamedPeak least_force();
NamedPeak least_torque();
NamedPeak peak_force();
NamedPeak outer_radius();
NamedPeak least_wall();
NamedPeak pivot_clearance();

}  // namespace camlaw::problems
