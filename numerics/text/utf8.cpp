// SPDX-License-Identifier: MIT
#include "numerics/text/utf8.h"

#include <cstddef>

namespace camlaw {
namespace {

/// How a character goes on after its first byte.
struct Rest {
  int bytes = 0;                               ///< that follow; -1: no character begins so
  unsigned char least = 0x80, largest = 0xBF;  ///< of the second byte
};

/// No character is written longer than it need be, none is half of a pair of UTF-16, and none lies
/// beyond U+10FFFF (RFC 3629).
Rest after(unsigned char first) {
  if (first < 0x80) return {};
  if (first < 0xC2 || first > 0xF4) return {-1};
  if (first < 0xE0) return {1};
  if (first < 0xF0) {
    return {2, static_cast<unsigned char>(first == 0xE0 ? 0xA0 : 0x80),
            static_cast<unsigned char>(first == 0xED ? 0x9F : 0xBF)};
  }
  return {3, static_cast<unsigned char>(first == 0xF0 ? 0x90 : 0x80),
          static_cast<unsigned char>(first == 0xF4 ? 0x8F : 0xBF)};
}

}  // namespace

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    Rest rest = after(static_cast<unsigned char>(text[i]));
    if (rest.bytes < 0) return false;
    for (; rest.bytes > 0; --rest.bytes) {
      if (++i == text.size()) return false;
      const auto byte = static_cast<unsigned char>(text[i]);
      if (byte < rest.least || byte > rest.largest) return false;
      rest.least = 0x80, rest.largest = 0xBF;
    }
  }
  return true;
}

}  // namespace camlaw
