// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

/// What goes to standard output and, in one line, to standard error. Nothing here throws: where
/// nobody reads any more, a command still goes on to write its files.
namespace camlaw::cli {

/// Text as people may read it, whoever wrote it: characters that command a terminal (all controls
/// but newline and tab) and marks that turn the direction of writing, by which a name can look like
/// another, are shown by their numbers, U+001B as "\u{1b}". Bytes that are not UTF-8 are shown as
/// "\x9b".
std::string visible(std::string_view text);

/// Text for people: made visible, with the colours of shaded().
void print_text(std::string_view text);
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  print_text(fmt::format(format, std::forward<Args>(args)...));
}

/// One line on standard error, "camlaw: ...": made visible, its line ends and tabs blanks. Silent
/// where there is nobody to read it.
void warn(std::string text);

/// Data for programs, such as JSON and CSV: as they are.
void print_data(std::string_view data);

/// Hands on what was printed; whether all of it arrived.
bool flush_printed();

/// Says that it has gone, where that was found otherwise.
void note_reader_gone();
/// Whether what reads standard output has gone, as `head` does when it has seen enough.
bool is_reader_gone();

enum class Shade { Good, Bad, Unsure };

/// Text that print_text shows in a colour; plain where standard output is not a terminal, or
/// NO_COLOR is set (no-color.org), or the terminal is dumb.
std::string shaded(const std::string& text, Shade shade);
/// The text without the marks that shaded() left in it.
std::string unshaded(std::string text);

}  // namespace camlaw::cli
