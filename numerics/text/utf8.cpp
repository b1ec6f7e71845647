// SPDX-License-Identifier: MIT
#include "numerics/text/utf8.h"

#include <cstddef>

namespace camlaw {
namespace {

/// How many bytes follow one that begins a character; -1 where it begins none.
int following(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  if (first >= 0xF0 && first < 0xF5) return 3;
  return -1;
}

}  // namespace

bool is_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (int left = following(byte(i)); left != 0; --left) {
      if (left < 0 || ++i == text.size() || (byte(i) & 0xC0) != 0x80) return false;
    }
  }
  return true;
}

}  // namespace camlaw
