// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace camlaw::problems {

/// "name=text", as a command's --set has it. Both are views of what was written.
struct SettingText {
  std::string_view name, text;
};

/// The two sides of the first '=', trimmed. Throws std::invalid_argument where there is none, or no
/// name; its message ends with the example.
SettingText parse_assignment(std::string_view written, std::string_view example);

}  // namespace camlaw::problems
