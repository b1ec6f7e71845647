// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.h"

/// What the program tells of itself in its manual page and to shells that complete its commands.
namespace camlaw::cli {

/// An option or a positional argument in words.
struct OptionPage {
  std::vector<std::string> names;  ///< "-q", "--quiet"; of a positional its one name
  std::string takes;               ///< empty: a switch
  std::string help;
  bool positional = false, required = false, repeats = false;

  /// "--param k=v", as a usage line has it.
  std::string shown() const;
};

struct CommandPage {
  std::string name, help;
  std::vector<OptionPage> options;  ///< positionals first
  std::vector<Example> examples;
};

/// "  LINE\n      WHAT\n" of each.
std::string example_lines(const std::vector<Example>& examples);

/// The program's own page and, after it, one for each command that --help lists.
std::vector<CommandPage> command_pages(const CommandTree& program);

}  // namespace camlaw::cli
