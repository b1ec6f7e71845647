// SPDX-License-Identifier: MIT
#include <memory>

#include "cli/command.h"
#include "output/answers/check_output.h"
#include "output/answers/next_step.h"

namespace camlaw::cli {
namespace {

struct CheckOptions {
  std::string file;
  CheckAsked asked;
  bool json = false;
};

int run_check(const CheckOptions& options) {
  const auto statement = problems::read_problem_file(options.file);
  const CheckedProblem checked = checked_problem(statement, options.asked, options.file);
  print(checked.document, options.json);
  if (!options.json && !options.asked.derivatives) {
    say_next(search_command(statement, options.file));
  }
  return checked.agrees ? kDone : kFailed;
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckOptions>();
  return {.name = "check",
          .help = "Check a problem file and restate it in words",
          .options = {problem_file(options->file),
                      {"--derivatives", &options->asked.derivatives, takes::kNothing,
                       "compare every derivative with finite differences"},
                      {"--scaling", &options->asked.scaling, takes::kNothing,
                       "show the scales of variables and limits"},
                      json_switch(options->json)},
          .examples = {{"camlaw check problems/cams/roller_least_base.toml",
                        "the file restated in words, with every name and unit checked"},
                       {"camlaw check problems/spine_cutter/least_force.toml --derivatives",
                        "its derivatives against finite differences"}},
          .run = [options] { return run_check(*options); }};
}

}  // namespace camlaw::cli
