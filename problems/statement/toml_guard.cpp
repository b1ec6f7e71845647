// SPDX-License-Identifier: MIT
#include "problems/statement/toml_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace camlaw::problems {
namespace {

bool is_between(char c, unsigned char low, unsigned char high) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= low && byte <= high;
}

/// Whether a letter of UTF-8 beyond ASCII may begin here: judged by two of its bytes.
bool begins_letter(std::string_view text) {
  return text.size() > 1 && is_between(text[0], 0xC2, 0xF4) && is_between(text[1], 0x80, 0xBF);
}

/// What to say of a byte beyond ASCII in neither quotes nor a comment.
std::string outside_ascii(std::string_view text) {
  if (!begins_letter(text)) return "it is not UTF-8; save the file as UTF-8 text";
  for (const std::string_view mark : {"“", "”", "„", "‘", "’", "‚", "«", "»"}) {
    if (text.starts_with(mark)) {
      return fmt::format("it is not valid TOML: write straight quotes, such as \"40 mm\", not {}",
                         mark);
    }
  }
  return "it is not valid TOML: put text with characters beyond a to z in quotes, such as "
         "\"größe\" or "
         "\"110°\"";
}

/// Walks through TOML and knows what is in quotes or a comment.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  }

  int line() const { return line_; }
  std::string_view rest() const { return text_; }

  /// Goes to where the text is in neither, unless it is there; false where it ends before.
  bool is_outside() {
    while (!text_.empty() && !end_.empty()) step_inside();
    return !text_.empty();
  }

  /// From outside past one byte, a mark that opens quotes, or the sign of a comment.
  void step_outside() {
    if (text_.front() == '#') end_ = "\n";
    for (const std::string_view mark : {"\"\"\"", "'''", "\"", "'"}) {
      if (!end_.empty() || !text_.starts_with(mark)) continue;
      end_ = mark;
      skip(mark.size() - 1);
    }
    skip(1);
  }

 private:
  void skip(std::size_t count) {
    for (const char c : text_.substr(0, count)) line_ += c == '\n' ? 1 : 0;
    text_.remove_prefix(std::min(count, text_.size()));
  }

  void step_inside() {
    const bool escaped = text_.front() == '\\' && end_.front() == '"';
    const bool broken_off = text_.front() == '\n' && end_.size() == 1;  // toml++ will tell
    if (!text_.starts_with(end_) && !broken_off) {
      skip(escaped ? 2 : 1);
      return;
    }
    const bool long_text = end_.size() == 3;  // may have two more quotes before those that end it
    const char quote = end_.front();
    skip(broken_off ? 1 : end_.size());
    for (int more = 0; long_text && more < 2 && text_.starts_with(quote); ++more) skip(1);
    end_ = {};
  }

  std::string_view text_;
  std::string_view end_;  ///< what ends the text or comment that we are in; empty outside
  int line_ = 1;
};

/// Points between the parts of a key, as far as the walk has come in it.
class KeyPoints {
 public:
  /// A byte in neither quotes nor comments.
  void take(char c) {
    constexpr std::string_view kOfKeys = "._- \t\"'";  // a part may be in quotes
    const bool of_key = is_between(c, 'a', 'z') || is_between(c, 'A', 'Z') ||
                        is_between(c, '0', '9') || kOfKeys.find(c) != std::string_view::npos;
    if (!of_key) count_ = 0;
    count_ += c == '.' ? 1 : 0;
  }
  int count() const { return count_; }

 private:
  int count_ = 0;
};

}  // namespace

void guard_toml(std::string_view text, const std::string& source) {
  // The parser calls itself for each: 15 000 have overflowed its stack.
  constexpr int kMostParts = 32;
  Walk walk(text);
  KeyPoints points;
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{}:{}: {}", source, walk.line(), why));
  };
  for (; walk.is_outside(); walk.step_outside()) {
    const char next = walk.rest().front();
    if (is_between(next, 0x80, 0xFF)) refuse(outside_ascii(walk.rest()));
    points.take(next);
    if (points.count() >= kMostParts) {
      refuse(fmt::format("a key has more than {} parts", kMostParts));
    }
  }
}

}  // namespace camlaw::problems
