// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/exit_status.h"

/// A command as data: what the parser, --help, the manual page and the shells' completions are all
/// made from.
namespace camlaw::cli {

/// What an option takes, as --help shows it and as shells complete it: one of these, or words in
/// braces, "{auto,sweep}".
namespace takes {
inline constexpr const char *kFile = "FILE", *kResult = "RESULT", *kFolder = "FOLDER",
                            *kLaw = "LAW", *kMechanism = "MECHANISM", *kSolver = "SOLVER",
                            *kSystem = "SYSTEM", *kNumber = "N", *kSampling = "METHOD N",
                            *kSetting = "NAME=VALUE", *kRange = "NAME=LOWER:UPPER", *kNothing = "";
}

/// An option or a positional argument.
struct Option {
  /// What it sets: a switch, which takes no value; a value; values, one each time that an option is
  /// given, all that are left of a positional.
  using Target =
      std::variant<bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*>;

  std::string names;  ///< "--out", "-o,--out"; of a positional "FILE"
  Target target;
  std::string takes;  ///< empty: a switch
  std::string help;
  bool required = false;
  std::string excludes = {};            ///< an option before it that it does not go with
  std::vector<std::string> words = {};  ///< of lists: all that may be in it; commas separate them

  bool is_switch() const { return std::holds_alternative<bool*>(target); }
  bool is_positional() const { return names.front() != '-'; }
  bool repeats() const { return std::holds_alternative<std::vector<std::string>*>(target); }
};

/// A command line that works as it stands in the project's folder, and what it is for.
struct Example {
  std::string line, what;
};

struct Command {
  std::string name, help;
  std::vector<Option> options;
  std::vector<Example> examples;
  /// Prints or writes its result; an ExitStatus. std::invalid_argument means bad input, any other
  /// exception a failure.
  std::function<int()> run;
  bool is_listed = true;  ///< by --help
};

/// --json.
Option json_switch(bool& on);
/// --set NAME=VALUE, as often as wanted: what problems::set_values takes.
Option set_option(std::vector<std::string>& settings);
/// --start RESULT, the design that a search begins with.
Option start_option(std::optional<std::string>& result);
/// FILE, the problem file.
Option problem_file(std::string& file);

}  // namespace camlaw::cli
