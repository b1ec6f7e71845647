// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "cli/files.h"
#include "cli/search_run.h"

/// The files that a command which searches writes to its --out folder.
namespace camlaw::cli {

/// Those that --out may make, the result first, once they are known to be writable.
std::vector<std::filesystem::path> checked_outputs(const SearchOptions& options,
                                                   const SearchCommand& command,
                                                   const problems::ProblemStatement& statement);

/// law.csv, law.svg and cycle.svg of an answer, where it has a design.
std::vector<OutputFile> answer_files(const Answer& answer, const std::filesystem::path& out);

}  // namespace camlaw::cli
