// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"
#include "problems/law_files/json_text.h"
#include "problems/law_files/pieces_json.h"

/// Laws as JSON. Numbers keep every digit that a double has; unbounded ones are the strings "inf"
/// and "-inf", undefined ones null.
namespace camlaw::cli {

using Json = problems::Json;
using problems::pieces_to_json;

Json to_json(double value);
Json to_json(const std::vector<double>& values);

/// The catalogue's object for a member: name, aliases, formula, parameters, constants, ends,
/// continuity, source.
Json law_to_json(const Member& member);

/// Enclosures of the peak constants: [low, high] each.
Json enclosures_to_json(const Peaks<Interval>& peaks);

}  // namespace camlaw::cli
