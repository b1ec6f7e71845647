// SPDX-License-Identifier: MIT
#pragma once

#include "tests/cli/program_runner.h"

/// What the program says of its commands and options, read as a person reads it.
namespace camlaw::cli {

/// The commands that --help lists.
Words commands();

/// An option that takes something.
struct OptionHelp {
  std::string name;   ///< "--out"
  std::string takes;  ///< "FILE", "{auto,sweep}", "N"
};

/// Those of a command, without switches and what stands without a name.
std::vector<OptionHelp> options_of(const std::string& command);

/// Options of a command that take nothing, but for --help and --quiet.
Words switches_of(const std::string& command);

/// Of the options the ones that name a file or a folder to be written.
std::vector<OptionHelp> outputs_of(const std::string& command);

}  // namespace camlaw::cli
