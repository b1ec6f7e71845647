// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace camlaw::problems {

/// JSON whose keys stay in their order. Here it is only named: who looks into one includes
/// <nlohmann/json.hpp>, in camlaw itself by json_text.h.
using Json = nlohmann::ordered_json;

}  // namespace camlaw::problems
