// SPDX-License-Identifier: MIT
#include "output/document/printing.h"

#include <fmt/color.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "numerics/text/utf8.h"

namespace camlaw::cli {
namespace {

bool reader_gone = false;

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != 0;
}

bool shows_colours() {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  return isatty(STDOUT_FILENO) != 0 && !is_set("NO_COLOR") && !dumb;
}

fmt::terminal_color colour_of(Shade shade) {
  switch (shade) {
    case Shade::Good:
      return fmt::terminal_color::green;
    case Shade::Bad:
      return fmt::terminal_color::red;
    case Shade::Unsure:
      break;
  }
  return fmt::terminal_color::yellow;
}

/// Marks about shaded text until it is printed: device controls, which no text of ours holds.
/// Another's text that holds them is coloured at most.
constexpr char kShadeEnds = '\x14';
char mark_of(Shade shade) { return static_cast<char>('\x11' + static_cast<int>(shade)); }

/// The code that begins a colour, or ends it where `mark` does; empty where colours are not shown.
std::string code_of(char mark, bool colours) {
  if (!colours) return {};
  if (mark == kShadeEnds) return "\x1b[0m";
  const auto shade = static_cast<Shade>(mark - '\x11');
  const std::string both = fmt::format(fmt::emphasis::bold | fmt::fg(colour_of(shade)), "{}", "|");
  return both.substr(0, both.find('|'));
}

bool is_mark(char c) { return c >= '\x11' && c <= kShadeEnds; }

/// Controls but newline and tab, line and paragraph separators, and the marks of direction of
/// Unicode's bidirectional algorithm (UAX 9).
bool is_hidden(std::uint32_t code) {
  if (code == '\n' || code == '\t') return false;
  const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool direction = code == 0x61c || code == 0x200e || code == 0x200f ||
                         (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return control || direction || code == 0x2028 || code == 0x2029;
}

/// Keeps the marks of shaded text where wanted.
std::string shown(std::string_view text, bool keeps_marks) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const auto [code, length] = first_character(text.substr(i));
    if (length == 0) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
    } else if (is_hidden(code) && !(keeps_marks && is_mark(text[i]))) {
      result += fmt::format("\\u{{{:x}}}", code);
    } else {
      result += text.substr(i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return result;
}

void note_failure() { reader_gone = reader_gone || errno == EPIPE; }

}  // namespace

std::string visible(std::string_view text) { return shown(text, false); }

void print_text(std::string_view text) {
  const bool colours = shows_colours();
  std::string coloured;
  for (const char c : shown(text, true)) {
    if (is_mark(c)) {
      coloured += code_of(c, colours);
    } else {
      coloured += c;
    }
  }
  print_data(coloured);
}

void warn(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  const std::string line = fmt::format("camlaw: {}\n", visible(text));
  std::fputs(line.c_str(), stderr);
}

void print_data(std::string_view data) {
  errno = 0;
  if (std::fwrite(data.data(), 1, data.size(), stdout) < data.size()) note_failure();
}

bool flush_printed() {
  errno = 0;
  if (std::fflush(stdout) != 0) note_failure();
  return std::ferror(stdout) == 0;
}

void note_reader_gone() { reader_gone = true; }
bool is_reader_gone() { return reader_gone; }

std::string shaded(const std::string& text, Shade shade) {
  return mark_of(shade) + text + kShadeEnds;
}

std::string unshaded(std::string text) {
  std::erase_if(text, is_mark);
  return text;
}

}  // namespace camlaw::cli
