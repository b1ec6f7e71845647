// SPDX-License-Identifier: MIT
#include "tests/cli/command_help.h"

#include <regex>

#include "tests/cli/shell.h"

namespace camlaw::cli {

Words commands() {
  Words names;
  const std::string help = done({"--help"});
  for (const std::string& line : lines_after(help.substr(help.find("Subcommands:")), "  ")) {
    if (line.starts_with("camlaw ")) break;  // the examples
    names.push_back(line.substr(0, line.find(' ')));
  }
  return names;
}

std::vector<OptionHelp> options_of(const std::string& command) {
  // "  -o,--out FILE               what it is for": two blanks or the line's end after what is
  // taken.
  static const std::regex kOption(R"((?:-\w,)?(--[\w-]+) (\S.*?)(?:  .*)?)");
  std::vector<OptionHelp> result;
  for (const std::string& line : lines_after(done({command, "--help"}), "  ")) {
    std::smatch parts;
    if (std::regex_match(line, parts, kOption) && !parts.str(2).empty()) {
      result.push_back({parts.str(1), parts.str(2)});
    }
  }
  return result;
}

Words switches_of(const std::string& command) {
  static const std::regex kSwitch(R"((?:-\w,)?(--[\w-]+)  .*)");
  Words result;
  for (const std::string& line : lines_after(done({command, "--help"}), "  ")) {
    std::smatch parts;
    if (!std::regex_match(line, parts, kSwitch)) continue;
    if (parts.str(1) != "--help" && parts.str(1) != "--quiet") result.push_back(parts.str(1));
  }
  return result;
}

std::vector<OptionHelp> outputs_of(const std::string& command) {
  std::vector<OptionHelp> result = options_of(command);
  std::erase_if(result,
                [](const OptionHelp& o) { return o.takes != "FILE" && o.takes != "FOLDER"; });
  return result;
}

}  // namespace camlaw::cli
