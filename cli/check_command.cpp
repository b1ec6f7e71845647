// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/optimum_output.h"
#include "optim/problem/check_derivatives.h"
#include "problems/statement/bind.h"

namespace camlaw::cli {
namespace {

struct CheckOptions {
  std::string file;
  bool derivatives = false, scaling = false;
};

std::string entry_text(const optim::DerivativeEntry& entry) {
  const std::string by = entry.second.empty()
                             ? entry.variable
                             : fmt::format("{} and {}", entry.variable, entry.second);
  return fmt::format("d({})/d({}){}: exact {:.12g}, by differences {:.12g}, error {:.1e}",
                     entry.response, by, entry.angle ? fmt::format(" at {:.6g}", *entry.angle) : "",
                     entry.exact, entry.difference, entry.error);
}

/// Prints what the differences say of one combination of options; whether they agree.
bool check_problem(const optim::Problem& problem, const std::string& label) {
  const auto result = optim::check_derivatives(problem, problem.start());
  if (!label.empty()) fmt::print("{}\n", label);
  fmt::print("{} derivatives compared with differences: {}\n", result.entries,
             result.agrees ? "all agree" : "they do not agree");
  if (result.entries > 0) fmt::print("worst: {}\n", entry_text(result.worst));
  for (const std::string& shape : result.shapes) fmt::print("{}\n", shape);
  return result.agrees && result.shapes.empty();
}

void run_check(const CheckOptions& options, int& status) {
  const auto statement = problems::read_problem_file(options.file);
  fmt::print("{}", problems::in_words(statement));
  if (!statement.objective) {
    if (options.derivatives || options.scaling) problems::BoundProblem{statement};  // says why not
    return;
  }
  const problems::BoundProblem bound(statement);
  const optim::ProblemSpace space = bound.space();
  const std::vector<std::size_t> first(space.choices.size(), 0);
  const optim::Problem problem = space.problem(first);
  problem.check();
  if (options.scaling) fmt::print("\n{}", scaling_text(problem));
  if (!options.derivatives) return;
  fmt::print("\n");
  // Laws differ in their formulas; other choices only in numbers.
  const bool laws = !space.choices.empty() && space.choices.front().name == "law";
  const std::size_t variants = laws ? space.choices.front().options.size() : 1;
  bool agrees = true;
  for (std::size_t i = 0; i < variants; ++i) {
    std::vector<std::size_t> chosen = first;
    if (laws) chosen.front() = i;
    const std::string label = laws ? "law " + space.choices.front().options[i] : "";
    agrees = check_problem(space.problem(chosen), label) && agrees;
  }
  if (!agrees) status = kFailed;
}

}  // namespace

void add_check_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("check", "Check a problem file and say it in words");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("FILE", options->file, "the problem file (TOML)")->required();
  command->add_flag("--derivatives", options->derivatives,
                    "compare every derivative with differences");
  command->add_flag("--scaling", options->scaling, "show what variables and limits are divided by");
  command->callback([options, &status] { run_check(*options, status); });
}

}  // namespace camlaw::cli
