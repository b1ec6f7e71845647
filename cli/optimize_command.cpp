// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/help.h"
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
  add_examples(*command,
               {{"camlaw optimize problems/spine_cutter/least_radius.toml",
                 "the least cam, with the price of each limit"},
                {"camlaw optimize problems/cams/roller_least_base.toml --out results/disc_cam",
                 "a disc cam, with the curves of its cycle"},
                {"camlaw optimize problems/spine_cutter/least_force.toml --solver ipopt --starts 4",
                 "another search for the same: the verdict does not depend on the solver"}});
  command->callback([options, optimize, &status] { status = run_search(*options, optimize); });
}

}  // namespace camlaw::cli
