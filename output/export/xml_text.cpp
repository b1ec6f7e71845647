// SPDX-License-Identifier: MIT
#include "output/export/xml_text.h"

#include <cstddef>

#include "numerics/text/utf8.h"

namespace camlaw::problems {
namespace {

/// Length in bytes of the UTF-8 character at the beginning of the text; 0 if there is none, or one
/// that XML does not allow.
std::size_t character_length(std::string_view text) {
  const Utf8Character first = first_character(text);
  return first.code == 0xFFFE || first.code == 0xFFFF ? 0 : first.length;
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
