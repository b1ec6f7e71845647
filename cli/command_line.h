// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

/// Command lines of a program with commands.
namespace camlaw::cli {

struct CommandTree {
  std::string name, help;
  std::vector<Command> commands;
  std::vector<Example> examples;
  std::string (*version)();
};

/// Options that every command has, and the program; they set nothing where `quiet` is null.
std::vector<Option> common_options(bool* quiet);
inline constexpr const char *kVersionOption = "--version",
                            *kVersionHelp =
                                "Print the versions of the program and of the libraries it uses",
                            *kHelpHelp = "Print this help message and exit";

/// Sets what the options of a command line are for. The command that it calls; none where it asked
/// for text alone, which is printed (--help, --version). Throws std::invalid_argument that names
/// what is not known, and what is near.
const Command* parsed(const CommandTree& program, int argc, const char* const* argv);

}  // namespace camlaw::cli
