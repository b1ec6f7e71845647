// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Words in double quotes, as people write names that hold commas or colons; a quote in the word is
/// doubled: "A ""long"" one".
namespace camlaw {

/// The word in quotes.
inline std::string in_quotes(std::string_view word) {
  std::string result = "\"";
  for (const char c : word) result.append(c == '"' ? 2 : 1, c);
  return result + '"';
}

/// Where the word that begins with a quote at the text's begin ends: behind its closing quote. npos
/// where none closes it.
inline std::size_t end_of_quoted(std::string_view text) {
  for (std::size_t end = text.find('"', 1); end != std::string_view::npos;
       end = text.find('"', end + 2)) {
    if (!text.substr(end + 1).starts_with('"')) return end + 1;
  }
  return std::string_view::npos;
}

/// The word without its quotes; a text that is not one word in quotes as it is.
inline std::string without_quotes(std::string_view text) {
  const bool is_quoted =
      text.size() >= 2 && text.starts_with('"') && end_of_quoted(text) == text.size();
  if (!is_quoted) return std::string(text);
  std::string word;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    word += text[i];
    if (text[i] == '"') ++i;
  }
  return word;
}

}  // namespace camlaw
