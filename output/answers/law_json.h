// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"
#include "output/document/json.h"
#include "problems/law_files/pieces_json.h"

/// Laws as JSON.
namespace camlaw::cli {

using problems::pieces_to_json;

/// The catalogue's object for a member: name, aliases, formula, parameters, constants, ends,
/// continuity, source.
Json law_to_json(const Member& member);

/// Enclosures of the peak constants: [low, high] each.
Json enclosures_to_json(const Peaks<Interval>& peaks);

}  // namespace camlaw::cli
