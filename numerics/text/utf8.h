// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace camlaw {

/// Whether each character is as UTF-8 writes characters (RFC 3629).
bool is_utf8(std::string_view text);

}  // namespace camlaw
