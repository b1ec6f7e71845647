// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "machines/cams/cam_tables.h"

/// Peaks and words that index drives have alike.
namespace camlaw::problems {

NamedPeak peak_turret_torque();
NamedPeak shaft_clearance();
/// Of a cam whose ribs run between the rollers.
std::vector<NamedPeak> rib_peaks();

/// Why a cam whose turret has so many stations and, on a circle, so many rollers does not meet
/// each of its rollers alike where a cycle advances by `advance` stations and hands over
/// `handovers` rollers; empty where it does.
std::string why_rollers_differ(double stations, double rollers, double advance, double handovers);

/// The same of a machine whose first parameters are its stations and its rollers.
std::string why_ribs_differ(std::span<const double> parameters, double advance);

}  // namespace camlaw::problems
