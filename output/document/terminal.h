// SPDX-License-Identifier: MIT
#pragma once

/// Manners on a terminal: what is said beside what was asked for.
namespace camlaw::cli {

/// --quiet: nothing but what was asked for; no progress, no word of files written.
void set_quiet(bool quiet);
bool is_quiet();

}  // namespace camlaw::cli
