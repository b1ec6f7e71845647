// SPDX-License-Identifier: MIT
#include "cli/search_outputs.h"

#include <string>
#include <utility>

#include "cli/earlier_results.h"
#include "output/answers/cycle_figure.h"
#include "output/figure/law_figure.h"

namespace camlaw::cli {
namespace {

/// All files that --out may make.
std::vector<std::filesystem::path> possible_files(const std::filesystem::path& out,
                                                  const std::vector<std::string>& names) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& name : names) paths.push_back(out / name);
  return paths;
}

/// check_out, with the files of a law that no law of this problem would write as left over.
void check_to_be_written(const std::vector<std::filesystem::path>& possible,
                         const problems::ProblemStatement& statement) {
  const bool has_law = statement.mechanism->moved_by != problems::MovedBy::Nothing;
  std::vector<std::filesystem::path> written, left;
  for (const std::filesystem::path& file : possible) {
    (has_law || file.stem() != "law" ? written : left).push_back(file);
  }
  check_out(written, left);
}

}  // namespace

std::vector<std::filesystem::path> checked_outputs(const SearchOptions& options,
                                                   const SearchCommand& command,
                                                   const problems::ProblemStatement& statement) {
  std::vector<std::string> names = command.files;
  if (command.more_files) {
    for (std::string& name : command.more_files(statement)) names.push_back(std::move(name));
  }
  auto possible = possible_files(options.out.value_or(""), names);
  if (options.out) {
    check_writable(possible);
    keep_other_results(possible, statement);
    check_to_be_written(possible, statement);
  }
  return possible;
}

std::vector<OutputFile> answer_files(const Answer& answer, const std::filesystem::path& out) {
  constexpr int kSamples = 361;  // both ends and a point each degree, were the motion one turn
  std::vector<OutputFile> files;
  if (const std::optional<Member> law = answer.law()) {
    const Law<double> shape = law->law();
    files.push_back({out / "law.csv", motion_csv(shape, kSamples)});
    files.push_back(
        {out / "law.svg", to_svg(motion_figure(law->label(), {{.name = "", .law = shape}}))});
  }
  const Figure cycle = cycle_figure(answer);
  if (!cycle.panels.empty()) files.push_back({out / "cycle.svg", to_svg(cycle)});
  return files;
}

}  // namespace camlaw::cli
