// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/rulers.h"
#include "cli/search_run.h"
#include "problems/law_files/law_file.h"

namespace camlaw::cli {
namespace {

void check_free(const problems::ProblemStatement& statement) {
  const bool free = std::any_of(statement.laws.begin(), statement.laws.end(),
                                [](const Member& law) { return bool(law.family->listed); });
  if (statement.mechanism->moved_by == problems::MovedBy::Program) {
    throw std::invalid_argument(statement.source +
                                ": synthesize takes a [law]; free laws in a [program] are for "
                                "'camlaw optimize'");
  }
  if (free) return;
  throw std::invalid_argument(statement.source +
                              ": no law of the problem is free; write [law] name = \"free\"");
}

/// Where a law's file comes from.
Json provenance(const Answer& answer) {
  const problems::ProblemStatement& statement = answer.bound.statement();
  const optim::Assessment& a = answer.optimum.found.assessment;
  return {{"problem", std::filesystem::path(statement.source).filename().string()},
          {"title", statement.title},
          {"verdict", std::string(optim::to_string(a.verdict))},
          {"objective", statement.objectives.front().response.name},
          {"value", to_json(a.objective.value)},
          {"unit", answer.optimum.problem.objective.response.unit}};
}

SearchReport report(const Answer& answer, const std::filesystem::path& out) {
  SearchReport result{answer_text(answer), answer_json(answer), answer_files(answer, out)};
  if (const auto law = answer.law()) {
    const std::string& stated = answer.bound.statement().title;
    const std::string title = stated.empty() ? law->label() : stated;
    result.files.push_back(
        {out / "law.json",
         problems::law_file(law->law(), title, provenance(answer)).dump(2) + "\n"});
  }
  const auto measured = rulers(answer);
  result.json["rulers"] = measured ? rulers_json(*measured) : Json(nullptr);
  if (measured) result.text += rulers_text(answer, *measured);
  return result;
}

}  // namespace

void add_synthesize_command(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("synthesize", "Find the best law there is for a problem file");
  const auto options = std::make_shared<SearchOptions>();
  add_search_options(*command, *options,
                     "result.json, law.json (the law's own file), law.csv, law.svg and cycle.svg");
  const SearchCommand synthesize{
      .files = {"result.json", "law.csv", "law.svg", "cycle.svg", "law.json"},
      .check = check_free,
      .report = report};
  command->callback([options, synthesize, &status] { status = run_search(*options, synthesize); });
}

}  // namespace camlaw::cli
