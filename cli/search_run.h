// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/run_limits.h"
#include "output/answers/optimum_output.h"
#include "problems/law_files/json_text.h"

/// What the commands that search have in common: their options, the search itself, what is printed
/// and written of it.
namespace camlaw::cli {

struct SearchOptions {
  std::string file;
  std::optional<std::string> solver, out, starts, seed, workers, start;
  RunLimits limits;
  std::vector<std::string> settings;
  bool json = false;
  bool table = false;  ///< of every combination of choices
};

/// FILE and the options; `files` names what --out writes.
std::vector<Option> search_options(SearchOptions& options, const std::string& files);

/// A command that searches.
struct SearchCommand {
  std::vector<std::string> files;  ///< all that --out may write, result.json first
  /// The same, of this problem alone.
  std::function<std::vector<std::string>(const problems::ProblemStatement&)> more_files = {};
  /// Throws std::invalid_argument for a problem that the command does not take.
  std::function<void(const problems::ProblemStatement&)> check;
  /// What takes a search of its own, after the answer's own text is out. `rest` says how to search,
  /// with the time that is left and the same stop, in so many processes.
  std::function<Document(const Answer&, const optim::OptimiseOptions& rest, int workers)> measure =
      {};
  /// The files of --out beside result.json, made where they are wanted only.
  std::function<std::vector<OutputFile>(const Answer&, const std::filesystem::path& out)> figures;
};

/// Reads the problem, searches, prints and writes. An ExitStatus.
int run_search(const SearchOptions& options, const SearchCommand& command);

}  // namespace camlaw::cli
