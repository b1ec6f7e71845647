// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace camlaw {

struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  ///< bytes; 0: there is none
};

/// The character that a text begins with, if it is as UTF-8 writes characters (RFC 3629): not
/// longer than it need be, not half of a pair of UTF-16, not beyond U+10FFFF.
Utf8Character first_character(std::string_view text);

/// Whether all of it are such characters.
bool is_utf8(std::string_view text);

}  // namespace camlaw
