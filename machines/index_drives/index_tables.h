// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "machines/cams/cam_tables.h"

/// Parameters, peaks and words that index drives have alike.
namespace camlaw::problems {

Parameters stations_parameter(double stations);
/// The distance of the axes and the radius of the rollers' circle, in mm.
Parameters index_sizes(double axis_distance, double turret_radius);
/// Rollers of a turret that has one ring of them.
Parameters turret_rollers(double rollers);
Parameters roller_radius_parameter(double radius);
/// Length and material of the contact along a roller.
Parameters roller_contact();
/// Speed of the cam, and what the turret asks for.
Parameters index_load();

/// Of the rollers' faces along their axes.
Parameters turret_crown();
/// The elastic train from the turret to the table that it turns.
Parameters table_train();

NamedPeak peak_turret_torque();
NamedPeak shaft_clearance();
/// Of a cam whose ribs run between the rollers.
std::vector<NamedPeak> rib_peaks();

/// Why a cam whose turret has so many stations and, on a circle, so many rollers does not meet
/// each of its rollers alike where a cycle advances by `advance` stations and hands over
/// `handovers` rollers; empty where it does.
std::string why_rollers_differ(double stations, double rollers, double advance, double handovers);

/// The same of a machine whose first parameters are stations_parameter() and turret_rollers().
std::string why_ribs_differ(std::span<const double> parameters, double advance);

}  // namespace camlaw::problems
