// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/model/mechanism.h"

/// Parameters and named peaks that several cams have alike.
namespace camlaw::problems {

using Parameters = std::vector<MechanismParameter>;

Parameters stroke_parameter();
Parameters swing_parameter();
Parameters base_parameter();
Parameters roller_parameter();
Parameters offset_parameter();
Parameters speed_parameter();
/// Mass, spring and load of a follower that slides, its spring's default rate and preload.
Parameters sliding_load(double rate, double preload);
/// Inertia, spring and load of an arm, its spring's default rate in N m/deg and preload.
Parameters oscillating_load(double rate, double preload);
/// Width and material of the contact.
Parameters contact_parameters();
Parameters cutter_parameter();
Parameters bore_parameter();
/// Archard's coefficient of a follower that slides on its cam.
Parameters wear_parameter();
/// Density of the cam, radius of its bore.
Parameters blank_parameters();
/// Friction in the guide of a sliding follower and its length.
Parameters friction_parameters();
/// The same and how far before its guide the follower meets its cam.
Parameters guide_parameters();
/// What the bearing of a roller, or of each of a pair, is made for.
Parameters bearing_parameters();
/// Of a roller's face along its axis.
Parameters crown_parameter();
/// What lubricates a contact: viscosity, pressure_viscosity, roughness.
Parameters lubricant_parameters();
/// What a roller bears, and what lubricates it, in the order of RollerDuty's fields.
Parameters duty_parameters();

/// The elastic train between cam and end, its stiffness in the unit of the follower's force by its
/// motion; without one, which is the default, the follower is rigid.
Parameters sliding_train();
Parameters oscillating_train();

/// One list after another.
Parameters joined(const std::vector<Parameters>& lists);

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
