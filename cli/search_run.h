// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/optimum_output.h"

/// What the commands that search have in common: their options, the search itself, what is printed
/// and written of it.
namespace camlaw::cli {

struct SearchOptions {
  std::string file;
  std::optional<std::string> solver, out, starts, seed, time_limit;
  bool json = false;
};

/// Adds FILE and the options; `files` names what --out writes.
void add_search_options(CLI::App& command, SearchOptions& options, const std::string& files);

/// What a command makes of an answer.
struct SearchReport {
  std::string text;
  Json json;
  std::vector<OutputFile> files;  ///< of --out, beside result.json
};

/// A command that searches.
struct SearchCommand {
  std::vector<std::string> files;  ///< all that --out may write, result.json first
  /// Throws std::invalid_argument for a problem that the command does not take.
  std::function<void(const problems::ProblemStatement&)> check;
  /// `out` is the folder of the files; empty where none is wanted.
  std::function<SearchReport(const Answer&, const std::filesystem::path& out)> report;
};

/// Reads the problem, searches, prints and writes. An ExitStatus.
int run_search(const SearchOptions& options, const SearchCommand& command);

/// law.csv, law.svg and cycle.svg of an answer, where it has a design.
std::vector<OutputFile> answer_files(const Answer& answer, const std::filesystem::path& out);

}  // namespace camlaw::cli
