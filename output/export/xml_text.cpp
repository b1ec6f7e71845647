// SPDX-License-Identifier: MIT
#include "output/export/xml_text.h"

#include <cstddef>

namespace camlaw::problems {
namespace {

/// Length in bytes of the UTF-8 character at the beginning of the text, 0 if it is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(text[i]) & 0xFFU; };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
  if (first < 0xC2U || first > 0xF4U || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  // Overlong forms, surrogates, beyond U+10FFFF, and U+FFFE and U+FFFF, which XML does not allow.
  const unsigned second = byte(1);
  if ((first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second > 0x9FU)) return 0;
  if ((first == 0xF0U && second < 0x90U) || (first == 0xF4U && second > 0x8FU)) return 0;
  return first == 0xEFU && second == 0xBFU && byte(2) > 0xBDU ? 0 : length;
}

/// An ASCII character for XML.
std::string escaped(char c) {
  switch (c) {
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '&':
      return "&amp;";
    case '"':
      return "&quot;";
    case '\'':
      return "&apos;";
    default:
      return std::string(1, c >= ' ' && c != '\x7f' ? c : ' ');
  }
}

}  // namespace

std::string xml_escape(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0)
      out += '?';
    else if (length == 1)
      out += escaped(text.front());
    else
      out += text.substr(0, length);
    text.remove_prefix(length > 0 ? length : 1);
  }
  return out;
}

}  // namespace camlaw::problems
