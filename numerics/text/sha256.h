// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace camlaw {

/// The SHA-256 digest of some bytes as 64 hexadecimal digits, as sha256sum prints it (FIPS 180-4,
/// "Secure Hash Standard", section 6.2).
std::string sha256(std::string_view bytes);

}  // namespace camlaw
