// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command_line.h"

/// The program.
namespace camlaw::cli {

/// What it is called, and all its commands.
CommandTree camlaw_program();

/// Runs the program; an ExitStatus.
int run(int argc, const char* const* argv);

}  // namespace camlaw::cli
