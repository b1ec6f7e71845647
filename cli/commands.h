// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

/// The program's commands. Each adds itself to the command line and, when called, prints or writes
/// its result; std::invalid_argument means bad input, any other exception a failure.
namespace camlaw::cli {

/// Exit status of the program.
enum ExitStatus : int {
  kDone = 0,
  kFailed = 1,
  kBadInput = 2,
  kInfeasible = 3,  ///< no design meets every limit
  kNotSolved = 4,   ///< no answer, or not the whole
};

void add_laws_command(CLI::App& app);
void add_mechanisms_command(CLI::App& app);
void add_law_command(CLI::App& app);
void add_study_command(CLI::App& app);
void add_fit_command(CLI::App& app);
void add_completion_command(CLI::App& app);
/// Prints the manual page; for the build, and not listed by --help.
void add_man_command(CLI::App& app);
/// These set `status` where they end in another way than done.
void add_reproduce_command(CLI::App& app, int& status);
void add_check_command(CLI::App& app, int& status);
void add_optimize_command(CLI::App& app, int& status);
void add_pareto_command(CLI::App& app, int& status);
void add_front_command(CLI::App& app, int& status);
void add_synthesize_command(CLI::App& app, int& status);
void add_report_command(CLI::App& app, int& status);
void add_evaluate_command(CLI::App& app, int& status);
void add_export_command(CLI::App& app, int& status);
void add_verify_command(CLI::App& app, int& status);

/// An option that is there or not, and takes no value: "--json=3" is an error.
CLI::Option* add_switch(CLI::App& command, const std::string& name, bool& on,
                        const std::string& help);

/// --set NAME=VALUE, as often as wanted: what problems::set_values takes.
void add_set_option(CLI::App& command, std::vector<std::string>& settings);

/// Runs the program; an ExitStatus.
int run(int argc, const char* const* argv);

}  // namespace camlaw::cli
