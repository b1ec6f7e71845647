// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// Manners on a terminal: what is said beside what was asked for, and in which colours.
namespace camlaw::cli {

/// --quiet: nothing but what was asked for; no progress, no word of files written.
void set_quiet(bool quiet);
bool is_quiet();

enum class Shade { Good, Bad, Unsure };

/// Text for standard output in a colour; as it is where that is no terminal, or NO_COLOR is set
/// (no-color.org), or the terminal is dumb.
std::string shaded(const std::string& text, Shade shade);

}  // namespace camlaw::cli
