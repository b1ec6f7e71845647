// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/statement/statement.h"

/// What one would do next, said after an answer.
namespace camlaw::cli {

/// A word of a shell's line, in quotes where it needs them.
std::string shell_word(const std::string& text);

/// "optimize FILE", or "pareto FILE" of several objectives, with what the command line has set;
/// empty of none.
std::string search_command(const problems::ProblemStatement& statement, const std::string& file,
                           const std::vector<std::string>& settings = {});

/// "next: camlaw COMMAND" on standard output; nothing with --quiet, or of an empty command.
void say_next(const std::string& command);

}  // namespace camlaw::cli
