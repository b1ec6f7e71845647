// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace camlaw::problems {

/// Refuses letters beyond ASCII outside quotes and comments, where TOML has none; `source` names
/// the text in errors. toml++ 3.3 must not see them: its test for white space runs into undefined
/// behaviour for letters from U+00A0 to U+0499 and some others. Throws std::invalid_argument with
/// the line.
void check_letters(std::string_view text, const std::string& source);

}  // namespace camlaw::problems
