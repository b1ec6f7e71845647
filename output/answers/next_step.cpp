// SPDX-License-Identifier: MIT
#include "output/answers/next_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "output/document/printing.h"
#include "output/document/terminal.h"

namespace camlaw::cli {

std::string shell_word(const std::string& text) {
  const bool is_plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) != 0 ||
           std::string_view("/._-+=:,@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (is_plain) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string search_command(const problems::ProblemStatement& statement, const std::string& file,
                           const std::vector<std::string>& settings) {
  if (statement.objectives.empty()) return "";
  const bool is_front = statement.objectives.size() > 1;
  std::string command = fmt::format("{} {}", is_front ? "pareto" : "optimize", shell_word(file));
  for (const std::string& set : settings) command += " --set " + shell_word(set);
  return command;
}

void say_next(const std::string& command) {
  if (!is_quiet() && !command.empty()) say("next: camlaw {}\n", command);
}

}  // namespace camlaw::cli
