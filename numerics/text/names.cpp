// SPDX-License-Identifier: MIT
#include "numerics/text/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace camlaw {
namespace {

/// The small letter of one that UTF-8 writes in two bytes; the same where it has none.
unsigned small_letter(unsigned code) {
  if (code >= 0xC0 && code <= 0xDE && code != 0xD7) return code + 0x20;  // Latin-1
  if (code >= 0x391 && code <= 0x3A9) return code + 0x20;                // Greek
  if (code >= 0x410 && code <= 0x42F) return code + 0x20;                // Cyrillic A to Ya
  if (code >= 0x400 && code <= 0x40F) return code + 0x50;                // Ukrainian Ye, I, Yi
  if (code == 0x490) return 0x491;                                       // G with upturn
  return code;
}

/// Likeness of two names, 0 to 1: Dice's coefficient on pairs of neighbouring bytes, the ends
/// marked.
double likeness(const std::string& a, const std::string& b) {
  const auto pairs = [](const std::string& name) {
    const std::string marked = "^" + name + "$";
    std::vector<std::string> result;
    for (std::size_t i = 0; i + 1 < marked.size(); ++i) result.push_back(marked.substr(i, 2));
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto pairs_a = pairs(a), pairs_b = pairs(b);
  std::vector<std::string> common;
  std::set_intersection(pairs_a.begin(), pairs_a.end(), pairs_b.begin(), pairs_b.end(),
                        std::back_inserter(common));
  return 2.0 * static_cast<double>(common.size()) /
         static_cast<double>(pairs_a.size() + pairs_b.size());
}

/// A name in a message: what() of an exception ends at a NUL character, which stands as \x00.
std::string in_message(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c == '\0') {
      result += "\\x00";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string folded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool is_pair = c >= 0xC0 && c < 0xE0 && i + 1 < text.size() &&
                         (static_cast<unsigned char>(text[i + 1]) & 0xC0U) == 0x80;
    if (!is_pair) {  // one byte, one of several, or no UTF-8
      const bool is_large = c >= 'A' && c <= 'Z';
      result += static_cast<char>(is_large ? c + ('a' - 'A') : c);
      continue;
    }
    const unsigned trail = static_cast<unsigned char>(text[++i]) & 0x3FU;
    const unsigned code = small_letter((c & 0x1FU) << 6U | trail);
    result += static_cast<char>(0xC0 | (code >> 6U));
    result += static_cast<char>(0x80 | (code & 0x3FU));
  }
  return result;
}

std::vector<std::string> near_names(std::string_view typed, const std::vector<std::string>& known) {
  const std::string wanted = folded(typed);
  // Of likeness: names with fewer letters in common are no slip of the pen.
  constexpr double kNear = 0.3;
  std::vector<std::pair<double, std::string>> ranked;
  for (const std::string& name : known) {
    const double alike = likeness(wanted, folded(name));
    if (alike >= kNear) ranked.emplace_back(alike, name);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> result;
  for (const auto& [alike, name] : ranked) {
    if (result.size() < 3) result.push_back(name);
  }
  return result;
}

std::string did_you_mean(const std::vector<std::string>& near) {
  if (near.empty()) return "";
  const std::string first = fmt::format("{}", fmt::join(near.begin(), near.end() - 1, ", "));
  return fmt::format("did you mean {}{}{}?", first, first.empty() ? "" : " or ", near.back());
}

void refuse_name(const std::string& what, std::string_view name,
                 const std::vector<std::string>& known, const std::string& list) {
  constexpr std::size_t kFew = 12;  // as many names fit on a line or two
  const auto near = near_names(name, known);
  if (near.empty() && known.size() == 1) {
    throw std::invalid_argument(
        fmt::format("{} '{}'; the only one is {}", what, in_message(name), known.front()));
  }
  const bool all = list.empty() || (near.empty() && known.size() <= kFew);
  const std::string names = fmt::format(" {}", fmt::join(known, ", "));
  throw std::invalid_argument(
      near.empty() ? fmt::format("{} '{}'; {}", what, in_message(name), all ? "use" + names : list)
                   : fmt::format("{} '{}'; {} {}", what, in_message(name), did_you_mean(near),
                                 all ? "Use" + names : list));
}

std::string_view trimmed(std::string_view text, std::string_view characters) {
  const std::size_t first = text.find_first_not_of(characters);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(characters) - first + 1);
}

std::vector<std::string_view> parted(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(mark);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace camlaw
