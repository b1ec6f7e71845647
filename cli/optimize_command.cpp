// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/search_run.h"

namespace camlaw::cli {

void add_optimize_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("optimize", "Find the best design of a problem file");
  const auto options = std::make_shared<SearchOptions>();
  add_search_options(*command, *options, "result.json, law.csv, law.svg and cycle.svg");
  const SearchCommand optimize{.files = {"result.json", "law.csv", "law.svg", "cycle.svg"},
                               .check = [](const problems::ProblemStatement&) {},
                               .report =
                                   [](const Answer& answer) {
                                     return SearchReport{answer_text(answer), answer_json(answer)};
                                   },
                               .figures = answer_files};
  command->callback([options, optimize, &status] { status = run_search(*options, optimize); });
}

}  // namespace camlaw::cli
