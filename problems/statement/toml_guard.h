// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace camlaw::problems {

/// Refuses what toml++ 3.3 must not see; `source` names the text in errors. Outside quotes and
/// comments that is letters beyond ASCII, where TOML has none (its test for white space runs into
/// undefined behaviour for letters from U+00A0 to U+0499 and some others), and keys of more than 32
/// parts, "a.b.c...", over which it recurses until the stack ends; brackets it counts itself.
/// Throws std::invalid_argument with the line.
void guard_toml(std::string_view text, const std::string& source);

}  // namespace camlaw::problems
