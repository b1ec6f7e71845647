// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/cli/shell.h"

namespace camlaw::cli {

/// A command of a page and the lines that the page shows of its output; "..." stands among them
/// where the page leaves lines out.
struct ConsoleStep {
  std::string command;
  Words lines;
};

/// The commands of a page: what stands between "```console" and "```", "$ command" and its lines.
std::vector<ConsoleStep> console_steps(const std::string& page);

/// Why the shown lines are not the output; empty where they are: every line of the output stands in
/// its order, whole, or up to a "..." at its end, and lines are left out only where "..." says so.
/// Empty lines do not count.
std::string console_difference(const Words& shown, const std::string& output);

/// Runs the commands of a page of the project and checks that they print what it shows; there are
/// `least` of them or more.
void check_page(const ProjectFolder& folder, const std::string& page, std::size_t least);

}  // namespace camlaw::cli
