// SPDX-License-Identifier: MIT
#include "cli/terminal.h"

#include <fmt/color.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace camlaw::cli {
namespace {

bool quiet_ = false;

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

}  // namespace

void set_quiet(bool quiet) { quiet_ = quiet; }
bool is_quiet() { return quiet_; }

std::string shaded(const std::string& text, Shade shade) {
  if (!shows_colours()) return text;
  return fmt::format(fmt::emphasis::bold | fmt::fg(colour_of(shade)), "{}", text);
}

}  // namespace camlaw::cli
