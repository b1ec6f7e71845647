// SPDX-License-Identifier: MIT
#pragma once

#include "cli/command.h"
#include "cli/command_line.h"

/// The program's commands, and the program.
namespace camlaw::cli {

Command laws_command();
Command mechanisms_command();
Command new_command();
Command examples_command();
Command law_command();
Command study_command();
Command reproduce_command();
Command check_command();
Command evaluate_command();
Command verify_command();
Command export_command();
Command optimize_command();
Command pareto_command();
Command front_command();
Command sweep_command();
Command synthesize_command();
Command tolerance_command();
Command fit_command();
Command report_command();
Command completion_command();
/// Prints the manual page; for the build, and not listed by --help.
Command man_command();

/// All of them.
Program camlaw_program();

/// Runs the program; an ExitStatus.
int run(int argc, const char* const* argv);

}  // namespace camlaw::cli
