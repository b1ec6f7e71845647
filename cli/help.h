// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// What the program tells of itself: --help, the man page and the shells' completions are all made
/// from the one tree of commands.
namespace camlaw::cli {

/// A command line that works as it stands in the project's folder, and what it is for.
struct Example {
  std::string line, what;
};

/// Ends the command's --help with examples.
void add_examples(CLI::App& command, const std::vector<Example>& examples);

/// What an option takes, as --help shows it and as shells complete it; `type_name` of an option is
/// one of these, or words in braces, "{auto,sweep}".
namespace takes {
inline constexpr const char *kFile = "FILE", *kFolder = "FOLDER", *kLaw = "LAW",
                            *kMechanism = "MECHANISM", *kSolver = "SOLVER", *kSystem = "SYSTEM";
}

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
  std::string name, help, examples;
  std::vector<OptionPage> options;  ///< positionals first
};

/// The program's own page and, after it, one for each command that --help lists.
std::vector<CommandPage> command_pages(const CLI::App& app);

}  // namespace camlaw::cli
