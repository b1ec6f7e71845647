// SPDX-License-Identifier: MIT
#include "problems/statement/letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace camlaw::problems {
namespace {

bool is_between(char c, unsigned char low, unsigned char high) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= low && byte <= high;
}

/// Whether a letter of UTF-8 beyond ASCII may begin here: two of its bytes are looked at.
bool begins_letter(std::string_view text) {
  return text.size() > 1 && is_between(text[0], 0xC2, 0xF4) && is_between(text[1], 0x80, 0xBF);
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

  /// Goes to the next letter beyond ASCII that is in neither; false where there is none.
  bool next_bare_letter() {
    while (!text_.empty()) {
      if (end_.empty() && is_between(text_.front(), 0x80, 0xFF)) return true;
      if (end_.empty()) {
        step_outside();
      } else {
        step_inside();
      }
    }
    return false;
  }

 private:
  void skip(std::size_t count) {
    for (const char c : text_.substr(0, count)) line_ += c == '\n' ? 1 : 0;
    text_.remove_prefix(std::min(count, text_.size()));
  }

  void step_outside() {
    if (text_.front() == '#') end_ = "\n";
    for (const std::string_view mark : {"\"\"\"", "'''", "\"", "'"}) {
      if (!end_.empty() || !text_.starts_with(mark)) continue;
      end_ = mark;
      skip(mark.size() - 1);
    }
    skip(1);
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

}  // namespace

void check_letters(std::string_view text, const std::string& source) {
  Walk walk(text);
  if (!walk.next_bare_letter()) return;
  throw std::invalid_argument(fmt::format("{}:{}: {}", source, walk.line(),
                                          begins_letter(walk.rest())
                                              ? "it is not TOML: letters beyond a to z stand in "
                                                "quotes, such as \"größe\""
                                              : "it is not UTF-8; save the file as UTF-8 text"));
}

}  // namespace camlaw::problems
