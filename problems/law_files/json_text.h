// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "problems/law_files/json_type.h"

namespace camlaw::problems {

/// Reads JSON that comes from outside. Throws std::invalid_argument for what is not JSON and for
/// brackets nested deeper than 64, which no file of camlaw has: what walks through them recurses.
Json parse_json(std::string_view text);

}  // namespace camlaw::problems
