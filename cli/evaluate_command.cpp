// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/law_json.h"
#include "cli/text_table.h"
#include "problems/statement/bind.h"

namespace camlaw::cli {
namespace {

using problems::EvaluatedResponse;
using problems::ProblemStatement;

struct EvaluateOptions {
  std::string file;
  std::vector<std::string> settings;
  bool json = false;
};

void print_text(const ProblemStatement& statement,
                const std::vector<EvaluatedResponse>& responses) {
  fmt::print("{}\nlaw {}\n\n", statement.title, statement.laws.front().label());
  TextTable table({{"response", TextTable::Align::Left},
                   {"value"},
                   {"lowest"},
                   {"at"},
                   {"highest"},
                   {"at"},
                   {"unit", TextTable::Align::Left},
                   {"meaning", TextTable::Align::Left}});
  for (const EvaluatedResponse& r : responses) {
    const auto shown = [](double value) { return fmt::format("{:.7g}", value); };
    const auto place = [](double value) { return fmt::format("{:.4g}", value); };
    if (r.is_curve) {
      table.add({r.name, "", shown(r.lowest), place(r.lowest_at), shown(r.highest),
                 place(r.highest_at), r.unit, r.meaning});
    } else {
      table.add({r.name, shown(r.value), "", "", "", "", r.unit, r.meaning});
    }
  }
  fmt::print("{}", table.text());
  const auto limits = problems::standing(statement);
  if (limits.empty()) return;
  fmt::print("\n");
  for (const auto& limit : limits) {
    fmt::print("{} {}: {:.7g} {} {:.7g} {}{}\n", limit.met ? "met" : "NOT met", limit.name,
               limit.value, limit.is_upper ? "<=" : ">=", limit.bound, limit.unit,
               limit.worst_angle ? fmt::format(" (worst at {:.4g})", *limit.worst_angle) : "");
  }
}

Json to_json(const ProblemStatement& statement, const std::vector<EvaluatedResponse>& responses) {
  Json values = Json::object();
  for (const EvaluatedResponse& r : responses) {
    if (r.is_curve) {
      values[r.name] = {{"lowest", cli::to_json(r.lowest)},
                        {"lowest_at", r.lowest_at},
                        {"highest", cli::to_json(r.highest)},
                        {"highest_at", r.highest_at},
                        {"unit", r.unit},
                        {"along", r.along}};
    } else {
      values[r.name] = {{"value", cli::to_json(r.value)}, {"unit", r.unit}};
    }
  }
  Json constants = Json::object();
  const auto& parameters = statement.mechanism->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    constants[parameters[i].name] = {{"value", statement.constants[i]},
                                     {"unit", parameters[i].unit}};
  }
  Json constraints = Json::array();
  for (const auto& limit : problems::standing(statement)) {
    constraints.push_back(
        {{"name", limit.name},
         {"value", cli::to_json(limit.value)},
         {"bound", limit.bound},
         {"margin", cli::to_json(limit.margin)},
         {"unit", limit.unit},
         {"worst_angle_deg", limit.worst_angle ? cli::to_json(*limit.worst_angle) : Json(nullptr)},
         {"met", limit.met}});
  }
  return {{"title", statement.title},
          {"mechanism", statement.mechanism->name},
          {"law", statement.laws.front().name()},
          {"constants", std::move(constants)},
          {"responses", std::move(values)},
          {"constraints", std::move(constraints)}};
}

void run_evaluate(const EvaluateOptions& options) {
  ProblemStatement statement = problems::read_problem_file(options.file);
  for (const std::string& setting : options.settings) problems::set_value(statement, setting);
  const auto responses = problems::evaluate(statement);
  if (options.json) {
    fmt::print("{}\n", to_json(statement, responses).dump(2));
  } else {
    print_text(statement, responses);
  }
}

}  // namespace

void add_evaluate_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Compute every response of a problem file's design");
  const auto options = std::make_shared<EvaluateOptions>();
  command->add_option("FILE", options->file, "the problem file (TOML)")->required();
  command
      ->add_option("--set", options->settings,
                   "set a variable or constant: name=value, such as --set 'stroke=30 mm'")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "print JSON");
  command->callback([options] { run_evaluate(*options); });
}

}  // namespace camlaw::cli
