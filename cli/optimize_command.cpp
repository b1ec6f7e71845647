// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/command.h"
#include "cli/search_outputs.h"
#include "cli/search_run.h"

namespace camlaw::cli {

Command optimize_command() {
  const auto options = std::make_shared<SearchOptions>();
  const SearchCommand optimize{.files = {"result.json", "law.csv", "law.svg", "cycle.svg"},
                               .check = [](const problems::ProblemStatement&) {},
                               .figures = answer_files};
  return {.name = "optimize",
          .help = "Find the best design of a problem file",
          .options = search_options(*options, "result.json, law.csv, law.svg and cycle.svg"),
          .examples =
              {{"camlaw optimize problems/spine_cutter/least_radius.toml",
                "the smallest cam, with the price of each limit"},
               {"camlaw optimize problems/cams/roller_least_base.toml --out results/disc_cam",
                "a disc cam, with the curves of its cycle"},
               {"camlaw optimize problems/spine_cutter/least_force.toml --solver ipopt --starts 4",
                "another search for the same: the verdict does not depend on the solver"}},
          .run = [options, optimize] { return run_search(*options, optimize); }};
}

}  // namespace camlaw::cli
