// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

/// The program's commands. Each adds itself to the command line and, when called, prints or writes
/// its result; std::invalid_argument means bad input, any other exception a failure.
namespace camlaw::cli {

void add_laws_command(CLI::App& app);
void add_law_command(CLI::App& app);
void add_study_command(CLI::App& app);
void add_reproduce_command(CLI::App& app);

/// Runs the program; the exit status: 0 done, 2 bad input, 1 anything else.
int run(int argc, const char* const* argv);

}  // namespace camlaw::cli
