// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numerics/tables/sample_table.h"

/// Units that tables do not state.
namespace camlaw::problems {

/// Gives a column that is named as an angle and states no unit the unit deg where its values go
/// over more than a turn of radians. What was done, in words; none where nothing was.
std::optional<std::string> assume_degrees(SampleColumn& column);

/// The same of a cam's profile: an angle and a radius, or x and y, without units; lengths become
/// mm. What was done, in words. Throws std::invalid_argument where the angle may be in rad or deg.
std::vector<std::string> assume_profile_units(SampleTable& table);

/// Whether columns x and y that state no unit go round the origin as a cam's profile does.
bool goes_round(const SampleTable& table);

}  // namespace camlaw::problems
